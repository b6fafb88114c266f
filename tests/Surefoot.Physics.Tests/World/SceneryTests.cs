using System.Numerics;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.World;

/// <summary>Trees and rocks: specification 05, 4.8 and 6.10.</summary>
public sealed class SceneryTests(FirstWorld files) : IClassFixture<FirstWorld>
{
    [Theory]
    [Behaviour("world.scenery.hashes", "spec/05, 6.10; @0x00530460, @0x005A5BB0")]
    [InlineData(0, 0, 0, .498242975, .956417106, .495964793, .214953439, .906296850, .793869082, .335634118)]
    [InlineData(1352, 1440, 0, .293549551, .089296138, .212507646, .039899140, .664703502, .429554777, .913056154)]
    [InlineData(1352, 1440, 1, .293549551, .357604139, .480815647, .308207141, .664703502, .697862778, .181364155)]
    [InlineData(1355, 1444, 0, .076810571, .897205804, .637407001, .937552771, .969455623, .429462582, .689885244)]
    [InlineData(1360, 1447, 2, .885931295, .070452728, .633239498, .272412302, .981127624, .829565663, .340420618)]
    [InlineData(2039, 2039, 3, .783766761, .507952111, .643145443, .095586649, .437324104, .604982624, .662102799)]
    public void Every_question_about_a_tree_has_the_answer_of_retail(
        uint x, uint y, uint k, double pick, double frequency, double shiftX, double shiftY, double quadrant, double rotation, double scale)
    {
        Assert.Equal(pick, Scenery.SceneShare(x, y), 1e-9);
        Assert.Equal(frequency, Scenery.Share(x, y, k, 23399), 1e-9);
        Assert.Equal(shiftX, Scenery.Share(x, y, k, 45773), 1e-9);
        Assert.Equal(shiftY, Scenery.Share(x, y, k, 72719), 1e-9);
        Assert.Equal(quadrant, Scenery.QuadrantShare(x, y), 1e-9);
        Assert.Equal(rotation, Scenery.Share(x, y, k, 63127), 1e-9);
        Assert.Equal(scale, Scenery.Share(x, y, k, 32593), 1e-9);
    }

    [Fact]
    [Behaviour("world.scenery.first-hash", "spec/05, 6.10")]
    public void The_answers_are_32_bit_numbers()
    {
        Assert.Equal(0x7F8CDA01u, Bits(Scenery.SceneShare(0, 0)));
        Assert.Equal(0xF4D7C05Fu, Bits(Scenery.Share(0, 0, 0, 23399)));
        Assert.Equal(0x7EF78C75u, Bits(Scenery.Share(0, 0, 0, 45773)));
        Assert.Equal(0x37073047u, Bits(Scenery.Share(0, 0, 0, 72719)));
        Assert.Equal(0xE8031203u, Bits(Scenery.QuadrantShare(0, 0)));
        Assert.Equal(0xCB3B010Fu, Bits(Scenery.Share(0, 0, 0, 63127)));
        Assert.Equal(0x55EC1E19u, Bits(Scenery.Share(0, 0, 0, 32593)));
    }

    [Fact]
    [Behaviour("world.scenery.stands-on-the-ground", "spec/05, 4.8")]
    public void Scenery_stands_on_free_ground_of_its_own_block()
    {
        int trees = 0;
        PhysicsWorld world = files.Load(FirstWorld.Blocks);
        foreach (Landblock block in world.Landblocks)
        {
            foreach (StaticObject item in SceneryOf(block))
            {
                trees++;
                Vector3 at = item.Position.Frame.Origin;
                Assert.True(CellIds.IsWithinBlock(at, 0));
                Assert.False(block.Terrain.IsOnRoad(at));
                Assert.True(block.Terrain.TryGetHeight(at.X, at.Y, out float ground));
                Assert.Equal(ground, at.Z);
                Assert.Null(((LandCell)item.Cell!).Building);
                Assert.True(item.Scale > 0);
            }
        }

        Assert.True(trees > 100, $"{trees} pieces of scenery");
    }

    private static uint Bits(double share) => (uint)(share * 4294967296.0);

    private IEnumerable<StaticObject> SceneryOf(Landblock block)
    {
        bool hasInfo = Surefoot.Dats.DatSourceExtensions.TryRead(files.Source, block.Id | 0xFFFE,
            out Surefoot.Dats.Records.LandBlockInfo? info);
        int placed = hasInfo ? info!.Objects.Length : 0;
        return block.StaticObjects.Skip(placed).Where(o => CellIds.IsOutdoor(o.Position.CellId));
    }
}
