namespace Surefoot.Dats;

/// <summary>The four files of the client (spec 07, 1.2).</summary>
public enum DatFileKind
{
    /// <summary><c>client_portal.dat</c>: all shared records.</summary>
    Portal,

    /// <summary><c>client_cell_1.dat</c>: land blocks and cells.</summary>
    Cell,

    /// <summary><c>client_local_English.dat</c>: texts and user-interface layouts.</summary>
    Local,

    /// <summary><c>client_highres.dat</c>: large textures.</summary>
    HighRes,
}
