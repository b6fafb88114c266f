using System.Security.Cryptography;
using Surefoot.Dats;

namespace Surefoot.DemoWorld;

/// <summary>Keeps written demo worlds outside the source tree, so that each is written once.</summary>
/// <remarks>
/// Worlds lie under <c>surefoot/demo-world</c> in <c>$SUREFOOT_CACHE</c> if that is set, else in the user's cache folder:
/// <c>$XDG_CACHE_HOME</c> or <c>~/.cache</c>; on Windows and macOS the local application data. A folder's name comes from
/// seed and program version, so a changed generator writes anew. Worlds that nobody asked for in 30 days are removed.
/// </remarks>
public static class DemoWorldCache
{
    /// <summary>Environment variable that names another folder for worlds.</summary>
    public const string FolderVariable = "SUREFOOT_CACHE";

    private static readonly TimeSpan KeepUnused = TimeSpan.FromDays(30);

    /// <summary>The folder in which worlds are kept.</summary>
    public static string Root
    {
        get
        {
            string? chosen = Environment.GetEnvironmentVariable(FolderVariable);
            return Path.Combine(string.IsNullOrWhiteSpace(chosen) ? UserCache() : chosen, "surefoot", "demo-world");
        }
    }

    /// <summary>The folder of a seed's world, written now if it is not there yet.</summary>
    /// <remarks>
    /// Safe to call from several threads and processes at once: a world appears whole or not at all, and all get the same. A cache that
    /// cannot be written to is replaced by a folder for temporary files.
    /// </remarks>
    /// <param name="seed">The world's seed.</param>
    /// <param name="progress">Told how far it is when the world has to be written.</param>
    /// <param name="notice">Told in one sentence when the cache cannot be written to.</param>
    /// <exception cref="IOException">The folder for temporary files cannot be written to either.</exception>
    /// <exception cref="UnauthorizedAccessException">It is not the caller's to write to.</exception>
    public static string GetOrCreate(
        uint seed = DemoWorldBuilder.DefaultSeed, IProgress<DemoWorldProgress>? progress = null, Action<string>? notice = null)
    {
        string root = Root;
        try
        {
            return GetOrCreateIn(root, seed, progress);
        }
        catch (Exception error) when (error is IOException or UnauthorizedAccessException)
        {
            string temporary = Path.Combine(Path.GetTempPath(), $"surefoot-{Environment.UserName}", "demo-world");
            if (temporary == root) throw;
            notice?.Invoke(
                $"the cache {root} cannot be written to ({error.Message.TrimEnd('.')}); the demo world is in {temporary}. " +
                $"Set {FolderVariable} to choose a folder.");
            return GetOrCreateIn(temporary, seed, progress);
        }
    }

    private static string GetOrCreateIn(string root, uint seed, IProgress<DemoWorldProgress>? progress)
    {
        string folder = Path.Combine(root, KeyOf(seed));
        if (IsComplete(folder))
        {
            Touch(folder);
            return folder;
        }

        Directory.CreateDirectory(root);
        RemoveUnused(root);
        string unfinished = Path.Combine(root, $"{Path.GetFileName(folder)}.{Guid.NewGuid():N}.tmp");
        try
        {
            DemoWorldBuilder.Write(unfinished, seed, progress);
            MoveInto(unfinished, folder);
        }
        finally
        {
            if (Directory.Exists(unfinished))
                Directory.Delete(unfinished, recursive: true);
        }

        return folder;
    }

    // Version ids of the compiled modules change with every change of their code, so nobody has to remember a number.
    private static string KeyOf(uint seed)
    {
        byte[] version =
        [
            .. typeof(DemoWorldCache).Module.ModuleVersionId.ToByteArray(),
            .. typeof(DatFileWriter).Module.ModuleVersionId.ToByteArray(),
            .. BitConverter.GetBytes(seed),
        ];
        return $"{seed}-{Convert.ToHexStringLower(SHA256.HashData(version))[..16]}";
    }

    private static bool IsComplete(string folder)
        => new[] { DatSet.PortalName, DatSet.CellName, DatSet.LocalName }.All(name => File.Exists(Path.Combine(folder, name)));

    private static void MoveInto(string unfinished, string folder)
    {
        for (int attempt = 0; ; attempt++)
        {
            try
            {
                // A damaged world would stand in the way for good.
                if (Directory.Exists(folder) && !IsComplete(folder))
                    Directory.Delete(folder, recursive: true);
                Directory.Move(unfinished, folder);
                return;
            }
            catch (IOException) when (IsComplete(folder))
            {
                // Another process was faster; its world has the same bytes.
                return;
            }
            catch (IOException) when (attempt < 3)
            {
                // Another process cleared the same damage at the same moment.
            }
        }
    }

    private static void Touch(string folder)
    {
        try
        {
            Directory.SetLastWriteTimeUtc(folder, DateTime.UtcNow);
        }
        catch (Exception error) when (error is IOException or UnauthorizedAccessException)
        {
            // A cache that can only be read still serves.
        }
    }

    private static void RemoveUnused(string root)
    {
        foreach (string folder in Directory.GetDirectories(root))
        {
            try
            {
                if (DateTime.UtcNow - Directory.GetLastWriteTimeUtc(folder) > KeepUnused)
                    Directory.Delete(folder, recursive: true);
            }
            catch (Exception error) when (error is IOException or UnauthorizedAccessException)
            {
                // In use or not ours: stays.
            }
        }
    }

    private static string UserCache()
    {
        if (!OperatingSystem.IsWindows() && !OperatingSystem.IsMacOS())
        {
            string? cache = Environment.GetEnvironmentVariable("XDG_CACHE_HOME");
            if (!string.IsNullOrEmpty(cache) && Path.IsPathRooted(cache))
                return cache;
            string home = Environment.GetFolderPath(Environment.SpecialFolder.UserProfile);
            if (home.Length > 0)
                return Path.Combine(home, ".cache");
        }

        string local = Environment.GetFolderPath(Environment.SpecialFolder.LocalApplicationData);
        return local.Length > 0 ? local : Path.GetTempPath();
    }
}
