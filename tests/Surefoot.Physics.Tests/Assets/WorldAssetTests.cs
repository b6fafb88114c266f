using Surefoot.Dats;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.Tests.Assets;

/// <summary>Every shape of whole worlds that others wrote.</summary>
public class WorldAssetTests
{
    [Theory, Behaviour("assets.worlds.all-load", "design: physics data loads for every GfxObj and EnvCell that has it")]
    [InlineData("first")]
    [InlineData("oracle")]
    public void Every_mesh_room_and_setup_of_a_world_loads_and_is_enclosed_by_its_bounds(string world)
    {
        using DatSet dats = DatSet.Open(Repository.PathOf("tests", "data", "worlds", world));
        PhysicsDataCache cache = new(dats);
        int meshes = 0, rooms = 0, setups = 0;
        foreach (uint id in dats.Portal.IdsOf(DatRecordType.GfxObj))
        {
            if (cache.GetGfxObj(id).Physics is not { } tree) continue;
            meshes++;
            AssertEnclosed(tree, id);
        }

        foreach (uint id in dats.Portal.IdsOf(DatRecordType.Environment))
        {
            foreach (CellStructAsset room in cache.GetEnvironment(id).Structures)
            {
                rooms++;
                AssertEnclosed(room.Physics, id);
            }
        }

        foreach (uint id in dats.Portal.IdsOf(DatRecordType.Setup))
        {
            SetupAsset setup = cache.GetSetup(id);
            setups++;
            Assert.True(setup.Parts.Length <= setup.Placement(0).Length, $"setup {id:X8} places its parts");
        }

        Assert.True(meshes > 5 && rooms > 2 && setups > 5, $"{meshes} meshes, {rooms} rooms, {setups} setups");
    }

    private static void AssertEnclosed(PhysicsBsp tree, uint id)
    {
        for (int i = 0; i < tree.Polygons.Count; i++)
        {
            Assert.Equal(1, RetailMath.Length(tree.Polygons.PlaneOf(i).Normal), 1e-5);
            foreach (System.Numerics.Vector3 corner in tree.Polygons.CornersOf(i))
            {
                Assert.True(RetailMath.Length(corner - tree.Bounds.Center) <= tree.Bounds.Radius + 0.01, $"{id:X8}, polygon {i}");
                Assert.Equal(0, RetailMath.Distance(tree.Polygons.PlaneOf(i), corner), 1e-2);
            }
        }
    }
}
