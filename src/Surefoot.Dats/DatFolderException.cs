namespace Surefoot.Dats;

/// <summary>A folder that is missing or lacks a dat file that is needed. The message is one line and says what to do.</summary>
public sealed class DatFolderException : FileNotFoundException
{
    /// <summary>Creates the error.</summary>
    /// <param name="folder">The folder that was asked for.</param>
    /// <param name="missing">What it lacks, as the middle of a sentence.</param>
    public DatFolderException(string folder, string missing)
        : base($"{missing}: point to a folder that holds client_portal.dat and client_cell_1.dat, "
            + "or make a demo world with 'surefoot demo write DIR'.")
        => Folder = folder;

    /// <summary>The folder that was asked for.</summary>
    public string Folder { get; }
}
