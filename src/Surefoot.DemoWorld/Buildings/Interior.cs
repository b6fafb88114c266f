using System.Collections.Immutable;
using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Placement;
using Surefoot.DemoWorld.Shapes;

namespace Surefoot.DemoWorld.Buildings;

/// <summary>Rooms that belong together, and the records made of them: one environment, and cells wherever it is placed.</summary>
internal sealed class Interior
{
    private readonly uint environmentId;
    private readonly List<RoomPlan> rooms = [];
    private readonly List<bool> seeOutside = [];

    // Rooms may change until records are asked for.
    private readonly Lazy<ImmutableArray<ImmutableArray<Face>>> faces;

    /// <summary>Starts without rooms.</summary>
    /// <param name="environmentId">Id of the environment that holds the rooms' shapes.</param>
    public Interior(uint environmentId)
    {
        this.environmentId = environmentId;
        faces = new(() => [.. rooms.Select(room => room.Faces())]);
    }

    /// <summary>Adds a room and gives its index.</summary>
    /// <param name="room">The room; finish it before records are made.</param>
    /// <param name="seesOutside">Whether the outdoors stays loaded while one is in it.</param>
    public int Add(RoomPlan room, bool seesOutside)
    {
        rooms.Add(room);
        seeOutside.Add(seesOutside);
        return rooms.Count - 1;
    }

    /// <summary>Joins two rooms by an opening that lies in a wall of both.</summary>
    public void Join(int a, int b, Box rectangle)
    {
        int openingOfA = rooms[a].Openings.Count, openingOfB = rooms[b].Openings.Count;
        rooms[a].Open(rectangle, b, openingOfB);
        rooms[b].Open(rectangle, a, openingOfA);
    }

    /// <summary>Opens a room to the outdoors.</summary>
    public void OpenOutside(int room, Box rectangle) => rooms[room].Open(rectangle, Opening.Outside, 0);

    /// <summary>The environment.</summary>
    public CellEnvironment Environment() => new()
    {
        Id = environmentId,
        Cells = [.. rooms.Select((room, index) => Meshes.Room(room.Space, faces.Value[index]) with { Key = (uint)index })],
    };

    /// <summary>The cells of one place.</summary>
    /// <param name="blockId">Upper half of the cell ids, e.g. 0xA8B50000.</param>
    /// <param name="firstCell">Low word of the first room's cell.</param>
    /// <param name="frame">Where the rooms' coordinates lie in the block.</param>
    public IEnumerable<EnvCell> Cells(uint blockId, ushort firstCell, Spot frame)
    {
        for (int room = 0; room < rooms.Count; room++)
        {
            int walls = faces.Value[room].Count(face => !face.IsPortal);
            uint id = blockId | (uint)(firstCell + room);
            yield return new()
            {
                Id = id,
                CellId = id,
                Flags = seeOutside[room] ? EnvCellFlags.SeenOutside : EnvCellFlags.None,
                SurfaceIds = Meshes.SurfacesOf(faces.Value[room]),
                EnvironmentId = environmentId,
                Structure = (ushort)room,
                Position = frame.ToFrame(),
                Portals = [.. rooms[room].Openings.Select((opening, index) => Portal(opening, (ushort)(walls + index), firstCell))],
                VisibleCells =
                    [.. Enumerable.Range(0, rooms.Count).Where(other => other != room).Select(other => (ushort)(firstCell + other))],
            };
        }
    }

    /// <summary>The ways in from outdoors, for the building's record.</summary>
    public ImmutableArray<BuildingPortal> WaysIn(ushort firstCell)
    {
        ImmutableArray<ushort> all = [.. Enumerable.Range(0, rooms.Count).Select(room => (ushort)(firstCell + room))];
        return
        [
            .. rooms.SelectMany((room, index) => room.Openings
                .Select((opening, number) => (opening, number))
                .Where(entry => entry.opening.OtherRoom == Opening.Outside)
                .Select(entry => new BuildingPortal(PortalFlags.ExactMatch, (ushort)(firstCell + index), (ushort)entry.number, all))),
        ];
    }

    // The polygons of openings face outwards, so the flag for inwards stays clear.
    private static CellPortal Portal(Opening opening, ushort polygon, ushort firstCell)
        => opening.OtherRoom == Opening.Outside
            ? new(PortalFlags.ExactMatch | PortalFlags.Outside, polygon, 0xFFFF, 0)
            : new(PortalFlags.ExactMatch, polygon, (ushort)(firstCell + opening.OtherRoom), (ushort)opening.OtherOpening);
}
