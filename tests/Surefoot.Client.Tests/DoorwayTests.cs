using System.Numerics;
using Surefoot.DemoWorld;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Client.Tests;

/// <summary>Doorways, doors and joints between rooms.</summary>
public sealed class DoorwayTests(DemoFiles files) : IClassFixture<DemoFiles>
{
    // The place "house-door" lies 10 m south of the middle of the house, whose door is in the wall at -6, 0.3 m thick.
    private const float DoorNorthOfPlace = 4;
    private const float HallLength = 6;
    private const uint Hall = 0x100, BackRoom = 0x101;
    private static readonly CharacterStats Runner = new(300, 200);

    [Fact]
    [Behaviour("obstacles.doorway-at-every-angle-keeps-the-room", "spec/05, 4.13 to 4.15; spec/03, 4.4")]
    public void A_doorway_is_passed_at_every_angle_without_losing_the_room()
    {
        for (int angle = -80; angle <= 80; angle += 5)
        {
            // The straight way clears the corners of the jambs, 0.6 m aside and 0.15 m before and behind the middle, by the body's radius
            // or more. A flatter way may be caught there, since a slide only bends a sub-step; it must not lose the room.
            double radians = angle * Math.PI / 180;
            bool clears = (0.6 * Math.Cos(radians)) - (0.15 * Math.Abs(Math.Sin(radians))) > 0.48;
            // Three metres from the middle of the doorway, aiming at it.
            DemoWalk walk = new(
                files, "house-door", Runner,
                eastward: (float)(-3 * Math.Sin(radians)), northward: (float)(DoorNorthOfPlace - 0.15 - (3 * Math.Cos(radians))),
                heading: angle);
            walk.Hold(MovementKeys.Forward, 40, () => AssertInTheRightCell(FromPortal(walk, DoorNorthOfPlace), walk, angle));
            if (clears) Assert.False(CellIds.IsOutdoor(walk.Position.CellId), $"at {angle} degrees the walk ended in {walk.Position}");

            // And out again the same way, from 2.5 m inside.
            DemoWalk back = new(
                files, "house-hall", Runner,
                eastward: (float)(2.5 * Math.Sin(radians)), northward: (float)((2.5 * Math.Cos(radians)) - 3.15), heading: angle + 180);
            back.Hold(MovementKeys.Forward, 40, () => AssertInTheRightCell(FromPortal(back, -3), back, angle));
            if (clears) Assert.True(CellIds.IsOutdoor(back.Position.CellId), $"at {angle} degrees the way out ended in {back.Position}");
        }
    }

    [Fact]
    [Behaviour("obstacles.corridor-joints-have-no-bump", "spec/05, 4.14; spec/03, 4.4")]
    public void A_corridor_of_rooms_is_run_through_without_a_bump_at_full_speed()
    {
        // The same run over the level meadow tells how far each frame carries.
        CharacterStats fastest = new(800, 200);
        DemoWalk walk = new(files, "dungeon-corridor", fastest), meadow = new(files, "runway", fastest, heading: 0);
        HashSet<uint> rooms = [];
        while (walk.Moved.Y < 33.5f)
        {
            walk.Hold(MovementKeys.Forward, 1);
            meadow.Hold(MovementKeys.Forward, 1);
            rooms.Add(walk.Position.CellId & 0xFFFF);
            Assert.Equal(meadow.Moved.Y, walk.Moved.Y, 1e-3);
            Assert.Equal(walk.RestHeight, walk.Z);
            Assert.Equal(0, walk.Moved.X, 1e-4);
            Assert.True(walk.Body.OnWalkable);
        }

        Assert.Equal([0x101u, 0x102u, 0x103u], rooms);
    }

    [Fact]
    [Behaviour("obstacles.closed-door-blocks", "spec/06, 2; spec/02, 4.21")]
    public void A_closed_door_blocks_and_an_open_one_lets_through()
    {
        // The door's house is turned by 30 degrees; one degree more, so that the run is not exactly head-on.
        DemoWalk walk = new(files, "door", Runner, heading: 31);
        PhysicsBody door = walk.Spawn(DemoSpawnKind.Door)[0];
        walk.Hold(MovementKeys.Forward, 20);
        Assert.True(CellIds.IsOutdoor(walk.Position.CellId), $"ran through the closed door into {walk.Position}");
        Assert.True(walk.Body.OnWalkable);
        Assert.True(door.SetEthereal(true));
        walk.Hold(MovementKeys.Forward, 60);
        Assert.False(CellIds.IsOutdoor(walk.Position.CellId), $"the open door holds at {walk.Position}");
    }

    [Fact]
    [Behaviour("obstacles.exactly-head-on-stays-blocked",
        "spec/03, 4.4 find_transitional_position 5c and adjust_offset; spec/02, 4.4 step 8")]
    public void Whoever_pushes_exactly_head_on_stays_blocked_by_the_door_that_opens_until_he_turns()
    {
        // The wall's normal of the last move is kept until a move succeeds, and takes the whole of a head-on sub-step.
        DemoWalk walk = new(files, "door", Runner);
        PhysicsBody door = walk.Spawn(DemoSpawnKind.Door)[0];
        walk.Hold(MovementKeys.Forward, 40);
        Vector3 held = walk.Moved;
        Assert.True(door.SetEthereal(true));
        walk.Hold(MovementKeys.Forward, 40);
        Assert.Equal(held, walk.Moved);
        walk.Face(31);
        walk.Hold(MovementKeys.Forward, 40);
        Assert.False(CellIds.IsOutdoor(walk.Position.CellId));
    }

    [Fact]
    [Behaviour("obstacles.door-closing-on-the-player-waits", "spec/02, 4.18 set_ethereal and 4.4 step 3")]
    public void A_door_that_closes_on_the_player_stays_open_until_the_doorway_is_free()
    {
        DemoWalk walk = new(files, "door", Runner);
        PhysicsBody door = walk.Spawn(DemoSpawnKind.Door)[0];
        Assert.True(door.SetEthereal(true));
        walk.Hold(MovementKeys.Forward, 60);
        Assert.False(CellIds.IsOutdoor(walk.Position.CellId));

        // Walk back out until the middle of the body is in the doorway, then close the door.
        CloseWhenInTheDoorway(walk, door);
        Vector3 held = walk.Moved;
        walk.Hold(MovementKeys.None, 30);
        Assert.Equal(PhysicsState.Ethereal, door.State & PhysicsState.Ethereal);
        Assert.True(Vector3.Distance(held, walk.Moved) < 0.2f, "the closing door pushed the player");

        walk.Hold(MovementKeys.Back | MovementKeys.Walk, 60);
        Assert.Equal(PhysicsState.None, door.State & PhysicsState.Ethereal);
        Assert.True(CellIds.IsOutdoor(walk.Position.CellId));
        walk.Hold(MovementKeys.Forward, 90);
        Assert.True(CellIds.IsOutdoor(walk.Position.CellId), "the door that has shut lets the player through");
    }

    private static void CloseWhenInTheDoorway(DemoWalk walk, PhysicsBody door)
    {
        for (int frame = 0; frame < 400; frame++)
        {
            walk.Hold(MovementKeys.Back | MovementKeys.Walk, 1);
            if (door.Position.OffsetTo(walk.Position).Length() > 0.3f) continue;
            Assert.False(door.SetEthereal(false));
            Assert.Equal(TransientState.CheckEthereal, door.Transient & TransientState.CheckEthereal);
            return;
        }

        Assert.Fail($"the way back out never came to the door; it ended at {walk.Position}");
    }

    /// <summary>The room begins where the door's portal is: at the inner side of the wall.</summary>
    private static void AssertInTheRightCell(Vector2 at, DemoWalk walk, int angle)
    {
        Assert.True(walk.Body.HasCell, $"no cell at {at}, {angle} degrees");
        Assert.True(walk.Body.OnWalkable, $"no ground at {at}, {angle} degrees");
        if (Math.Abs(at.Y) < 0.001f || Math.Abs(at.Y - HallLength) < 0.001f) return;
        uint cell = walk.Position.CellId;
        if (at.Y > 0) Assert.True((cell & 0xFFFF) == (at.Y < HallLength ? Hall : BackRoom), $"{at} is not in {cell:X8}; {angle} degrees");
        else Assert.True(CellIds.IsOutdoor(cell), $"{at} is outdoors, not in {cell:X8}; {angle} degrees");
    }

    /// <summary>
    /// Metres east of the middle of the doorway and north of the portal, which is so far north of the place the walk began at.
    /// </summary>
    private static Vector2 FromPortal(DemoWalk walk, float northOfPlace) => new(walk.FromPlace.X, walk.FromPlace.Y - northOfPlace);
}
