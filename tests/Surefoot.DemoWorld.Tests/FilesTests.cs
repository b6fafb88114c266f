using System.Buffers;
using System.Security.Cryptography;
using Surefoot.Dats;
using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Land;

namespace Surefoot.DemoWorld.Tests;

public sealed class FilesTests(DemoFolder world) : IClassFixture<DemoFolder>
{
    [Fact, Behaviour("demo-world.files.same-seed-same-bytes", "spec/07, 5.1")]
    public void The_same_seed_gives_the_same_bytes()
    {
        string again = Directory.CreateTempSubdirectory("surefoot-demo-").FullName;
        try
        {
            DemoWorldBuilder.Write(again);
            foreach (string name in new[] { DatSet.PortalName, DatSet.CellName, DatSet.LocalName })
                Assert.Equal(HashOf(Path.Combine(world.Path, name)), HashOf(Path.Combine(again, name)));
        }
        finally
        {
            Directory.Delete(again, recursive: true);
        }
    }

    [Fact, Behaviour("demo-world.files.other-seed-other-land", "spec/07, 7.12")]
    public void Another_seed_gives_another_land()
    {
        DemoTerrain a = DemoTerrain.Create(1), b = DemoTerrain.Create(2);
        int different = 0;
        for (int column = 0; column <= 64; column++)
        {
            for (int row = 0; row <= 64; row++)
                different += a.HeightIndex(column, row) != b.HeightIndex(column, row) ? 1 : 0;
        }

        Assert.InRange(different, 1000, 65 * 65);
    }

    [Fact, Behaviour("demo-world.files.every-record-reads-back", "spec/07, 7")]
    public void Every_record_is_read_and_encoded_to_the_same_bytes()
    {
        int records = 0;
        foreach (var file in world.Dats.Files)
        {
            Assert.Empty(file.Damage);
            Assert.Empty(file.Remarks);
            foreach (uint id in file.Ids)
            {
                Assert.True(file.TryRead(id, out var bytes));
                Assert.Equal(bytes.ToArray(), Decode(DatIds.RecordTypeOf(id, file.Kind), id, bytes).Encode());
                records++;
            }
        }

        Assert.True(records > 100 + 40);
    }

    [Fact, Behaviour("demo-world.files.name-only-records-that-exist", "spec/07, 9.1")]
    public void Every_id_that_a_record_names_exists()
    {
        var dats = world.Dats;
        var named = new SortedSet<uint>();
        foreach (uint id in dats.IdsOf(DatRecordType.Setup))
        {
            var setup = dats.Read<Setup>(id);
            named.UnionWith(setup.PartIds);
            named.UnionWith(
                new[] { setup.DefaultAnimationId, setup.DefaultMotionTableId, setup.DefaultScriptId }.Where(other => other != 0));
        }

        foreach (uint id in dats.IdsOf(DatRecordType.GfxObj))
            named.UnionWith(dats.Read<GfxObj>(id).SurfaceIds);
        foreach (var scenes in world.Region.SceneTypes)
            named.UnionWith(scenes.SceneIds);
        foreach (uint id in dats.IdsOf(DatRecordType.Scene))
            named.UnionWith(dats.Read<Scene>(id).Objects.Select(thing => thing.ObjectId));
        foreach (uint id in dats.IdsOf(DatRecordType.MotionTable))
        {
            var table = dats.Read<MotionTable>(id);
            named.UnionWith(table.Cycles.Concat(table.Modifiers).Concat(table.Links.SelectMany(link => link.Targets))
                .SelectMany(motion => motion.Data.Animations).Select(animation => animation.AnimationId));
        }

        Assert.NotEmpty(named);
        Assert.All(named, id => Assert.True(dats.Portal.TryGetEntry(id, out _), $"0x{id:X8} is missing"));
    }

    [Fact, Behaviour("demo-world.files.bad-directory-is-refused", "design.md, decision 7")]
    public void An_empty_directory_name_is_refused() => Assert.Throws<ArgumentException>(() => DemoWorldBuilder.Write(" "));

    private static string HashOf(string path) => Convert.ToHexString(SHA256.HashData(File.ReadAllBytes(path)));

    private static DatRecord Decode(DatRecordType type, uint id, ReadOnlySequence<byte> bytes) => type switch
    {
        DatRecordType.Animation => DatRecord.Decode<Animation>(id, bytes),
        DatRecordType.EnvCell => DatRecord.Decode<EnvCell>(id, bytes),
        DatRecordType.Environment => DatRecord.Decode<CellEnvironment>(id, bytes),
        DatRecordType.GfxObj => DatRecord.Decode<GfxObj>(id, bytes),
        DatRecordType.Iteration => DatRecord.Decode<IterationRecord>(id, bytes),
        DatRecordType.LandBlock => DatRecord.Decode<LandBlock>(id, bytes),
        DatRecordType.LandBlockInfo => DatRecord.Decode<LandBlockInfo>(id, bytes),
        DatRecordType.MotionTable => DatRecord.Decode<MotionTable>(id, bytes),
        DatRecordType.Region => DatRecord.Decode<Region>(id, bytes),
        DatRecordType.Scene => DatRecord.Decode<Scene>(id, bytes),
        DatRecordType.Setup => DatRecord.Decode<Setup>(id, bytes),
        _ => RawRecord.FromBytes(id, type, bytes),
    };
}
