using Surefoot.Dats;
using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Tests;

/// <summary>A written demo world, read back; removed at the end of the tests that share it.</summary>
public sealed class DemoFolder : IDisposable
{
    public DemoFolder()
    {
        Path = Directory.CreateTempSubdirectory("surefoot-demo-").FullName;
        DemoWorldBuilder.Write(Path);
        Dats = DatSet.Open(Path);
    }

    public string Path { get; }

    public DatSet Dats { get; }

    public Region Region => Dats.Read<Region>(DatIds.Region);

    public void Dispose()
    {
        Dats.Dispose();
        Directory.Delete(Path, recursive: true);
    }

    public LandBlock Block(int x, int y) => Dats.Read<LandBlock>(DatIds.LandBlock(x, y));
}
