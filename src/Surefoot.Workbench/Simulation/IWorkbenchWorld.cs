using System.Numerics;
using Surefoot.Protocol.Session;
using Surefoot.Server;
using Surefoot.Workbench.Wire;

namespace Surefoot.Workbench.Simulation;

/// <summary>The world that pages play in. One thread calls it, but terrain and shapes are read from any thread.</summary>
internal interface IWorkbenchWorld : IDisposable
{
    /// <summary>Name shown on the page.</summary>
    string Name { get; }

    /// <summary>Places to go to; the first is where a player enters. Never empty.</summary>
    IReadOnlyList<WorkbenchPlace> Places { get; }

    /// <summary>What the world does without so far. May be asked for on any thread.</summary>
    LeftOutNotice LeftOut { get; }

    /// <summary>Burden units that a player carries at load 1.</summary>
    int BurdenCapacity { get; }

    /// <summary>Puts a new player into the world.</summary>
    /// <param name="id">Its id, unique.</param>
    /// <param name="settings">Skills and burden.</param>
    /// <param name="place">Where.</param>
    /// <param name="now">Seconds.</param>
    IWorkbenchPlayer Join(uint id, PlayerSettings settings, WorkbenchPlace place, double now);

    /// <summary>Takes a player out, for good.</summary>
    void Leave(IWorkbenchPlayer player);

    /// <summary>Brings the world to <paramref name="now"/>; true when a tick of the physics was made.</summary>
    bool Advance(double now);

    /// <summary>Lists the other players as a player's page sees them, in the order of their coming.</summary>
    /// <param name="player">Who looks.</param>
    /// <param name="near">Is filled anew.</param>
    void LookAtPlayers(IWorkbenchPlayer player, List<(uint Id, PlayerPose Pose)> near);

    /// <summary>Lists where the others that a player's page sees are in truth; nothing where it does not want to know.</summary>
    /// <param name="player">Who looks.</param>
    /// <param name="near">Is filled anew.</param>
    void LookAtTruth(IWorkbenchPlayer player, List<TruePlace> near);

    /// <summary>Lists the bodies near a player that are no players, as its page sees them, in the order of their ids.</summary>
    /// <param name="player">Who looks.</param>
    /// <param name="near">Is filled anew.</param>
    void Look(IWorkbenchPlayer player, List<BodyPose> near);

    /// <summary>Lists the parts near a player that animations move, in the order of their landblocks, objects and parts.</summary>
    /// <param name="player">Who looks.</param>
    /// <param name="near">Is filled anew.</param>
    void LookAtParts(IWorkbenchPlayer player, List<MovingPart> near);

    /// <summary>The terrain of a landblock as the physics built it, or null where there is none.</summary>
    /// <param name="block">0xXXYY.</param>
    TerrainBlock? ReadTerrain(ushort block);

    /// <summary>What stands on a landblock and under it, or null where there is nothing.</summary>
    /// <param name="block">0xXXYY.</param>
    BlockShapes? ReadShapes(ushort block);
}

/// <summary>One page's player.</summary>
internal interface IWorkbenchPlayer
{
    /// <summary>State after the last tick.</summary>
    PlayerPose Pose { get; }

    /// <summary>What it stands on, if anything, and what it touches.</summary>
    IReadOnlyList<Touch> Touches { get; }

    /// <summary>What it did last, as a command.</summary>
    WalkReport Walk { get; }

    /// <summary>The keys held from now on.</summary>
    void SetKeys(PlayerKeys keys, double now);

    /// <summary>The pointer's buttons held from now on, and how far it moved to the right, counts.</summary>
    void MovePointer(PointerButtons held, float right, double now);

    /// <summary>The right button turns the player, or does not.</summary>
    void UseMouseTurning(bool on, double now);

    /// <summary>Runs ahead without a key, or no longer.</summary>
    void ToggleAutoRun(double now);

    /// <summary>The keyboard is elsewhere: every key counts as let go.</summary>
    void LoseFocus(double now);

    /// <summary>New skills and burden.</summary>
    void Configure(PlayerSettings settings, double now);

    /// <summary>Places the player, on the ground where the height is NaN; when nobody can be there, an event says so.</summary>
    void Goto(WorkbenchPlace place, double now);

    /// <summary>Opens or closes the nearest door within reach, if there is one.</summary>
    void Use(double now);

    /// <summary>A creature is to do something from now on.</summary>
    /// <param name="creature">Id of its body.</param>
    /// <param name="wish">What.</param>
    void Ask(uint creature, CreatureWish wish);

    /// <summary>How bad the network is over which the page hears of others, and whether it wants to know where they are in truth.</summary>
    void UseNetwork(NetworkQuality quality, bool showsTruth);

    /// <summary>The oldest event not yet taken.</summary>
    bool TryTakeEvent(out PlayerEvent happened);

    /// <summary>The oldest sentence not yet taken that a person should read.</summary>
    bool TryTakeSentence(out string sentence);
}

/// <summary>What a player did last.</summary>
/// <param name="Command">The command line that does the same.</param>
/// <param name="LeftOut">What was done that it does without, in words; empty when that is nothing.</param>
internal readonly record struct WalkReport(string Command, string LeftOut);

/// <summary>What the page draws of a landblock: 9 × 9 vertices, 8 × 8 cells, column (x) major.</summary>
/// <param name="Heights">81 heights, metres, index 9·i + j.</param>
/// <param name="Terrain">81 terrain words (road in bits 0–1, type in bits 2–6), same index.</param>
/// <param name="SouthWestCut">64 split directions, true for SW–NE, index 8·i + j.</param>
internal sealed record TerrainBlock(float[] Heights, ushort[] Terrain, bool[] SouthWestCut);

/// <summary>What bodies collide with on a landblock. Triangles are three corners each, metres in the block.</summary>
/// <param name="Objects">Triangles of objects outdoors.</param>
/// <param name="Rocks">Triangles of scenery outdoors.</param>
/// <param name="Shells">Outsides of buildings.</param>
/// <param name="Rooms">Rooms, each with what stands in it.</param>
/// <param name="Plants">Scenery without polygons.</param>
/// <param name="Moving">Parts that animations move.</param>
internal sealed record BlockShapes(
    Vector3[] Objects, Vector3[] Rocks, IReadOnlyList<NamedShape> Shells, IReadOnlyList<NamedShape> Rooms, IReadOnlyList<Plant> Plants,
    IReadOnlyList<MovingShape> Moving);

/// <summary>Triangles that belong together.</summary>
/// <param name="Id">Id of a room's cell, or of a building's model.</param>
/// <param name="Triangles">Three corners each, metres in the block.</param>
internal sealed record NamedShape(uint Id, Vector3[] Triangles);

/// <summary>A piece of scenery that stops bodies by an upright cylinder, as trees do, or a sphere, as shrubs do.</summary>
/// <param name="Low">The middle of its lowest disc, or its lowest point; metres in the block.</param>
/// <param name="Radius">Metres.</param>
/// <param name="Height">Metres.</param>
/// <param name="IsRound">It is a sphere.</param>
internal readonly record struct Plant(Vector3 Low, float Radius, float Height, bool IsRound);

/// <summary>A part of an object that an animation moves.</summary>
/// <param name="Object">Which of the landblock's animated statics.</param>
/// <param name="Part">Which part of it.</param>
/// <param name="Triangles">Three corners each, metres in the part's own frame at scale 1.</param>
internal sealed record MovingShape(ushort Object, ushort Part, Vector3[] Triangles);

/// <summary>Where such a part is after the last tick of the physics.</summary>
/// <param name="Block">Landblock, 0xXXYY.</param>
/// <param name="Object">Which of the landblock's animated statics.</param>
/// <param name="Part">Which part of it.</param>
/// <param name="Position">Metres in the landblock.</param>
/// <param name="Rotation">Orientation.</param>
/// <param name="Scale">Scale of the part.</param>
internal readonly record struct MovingPart(ushort Block, ushort Object, ushort Part, Vector3 Position, Quaternion Rotation, float Scale);
