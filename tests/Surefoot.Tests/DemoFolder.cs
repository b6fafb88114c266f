using Surefoot.DemoWorld;

namespace Surefoot.Tests;

/// <summary>The demo world's files in a folder of their own.</summary>
public sealed class DemoFolder : IDisposable
{
    public DemoFolder() => DemoWorldBuilder.Write(Path);

    public string Path { get; } = Directory.CreateTempSubdirectory("surefoot-door-").FullName;

    public void Dispose() => Directory.Delete(Path, recursive: true);
}
