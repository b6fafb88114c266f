using System.Numerics;
using CsCheck;
using Surefoot.DemoWorld;

namespace Surefoot.Client.Tests.Properties;

/// <summary>What somebody does for a while.</summary>
/// <param name="Keys">Keys held.</param>
/// <param name="Frames">For how many frames.</param>
/// <param name="Push">Velocity given at the beginning, m/s; zero for none.</param>
internal readonly record struct Deed(MovementKeys Keys, int Frames, Vector3 Push);

/// <summary>Who makes a trip.</summary>
internal enum Traveller
{
    /// <summary>A player with keys.</summary>
    Player,

    /// <summary>A human body that strides as it is told; it walks off edges.</summary>
    Careless,

    /// <summary>A creature of two small spheres.</summary>
    Creature,

    /// <summary>A ball of one sphere that is thrown.</summary>
    Ball,

    /// <summary>A missile.</summary>
    Missile,

    /// <summary>A human one and a half times as large.</summary>
    Giant,
}

/// <summary>Where somebody begins in the demo world, what he can, and what he does.</summary>
/// <param name="Who">Who travels.</param>
/// <param name="Place">Index of a named place.</param>
/// <param name="Offset">Way from there, metres; upwards from the ground.</param>
/// <param name="Heading">Degrees clockwise from north.</param>
/// <param name="RunSkill">Run skill.</param>
/// <param name="JumpSkill">Jump skill.</param>
/// <param name="FrameTime">Length of a frame in quanta of 1/30 s.</param>
/// <param name="Deeds">In this order.</param>
internal sealed record Trip(
    Traveller Who, int Place, Vector3 Offset, float Heading, int RunSkill, int JumpSkill, int FrameTime, Deed[] Deeds)
{
    private static readonly MovementKeys[] Held =
    [
        MovementKeys.None, MovementKeys.Forward, MovementKeys.Forward, MovementKeys.Forward, MovementKeys.Forward | MovementKeys.Walk,
        MovementKeys.Back,
        MovementKeys.SidestepLeft, MovementKeys.SidestepRight, MovementKeys.Forward | MovementKeys.TurnLeft,
        MovementKeys.Forward | MovementKeys.TurnRight,
        MovementKeys.TurnLeft, MovementKeys.TurnRight, MovementKeys.Forward | MovementKeys.SidestepLeft,
        MovementKeys.Forward | MovementKeys.SidestepRight,
        MovementKeys.Forward | MovementKeys.Jump, MovementKeys.Jump, MovementKeys.Back | MovementKeys.Jump,
    ];

    private static readonly Gen<Vector3> Push = Gen.Frequency(
        (6, Gen.Const(Vector3.Zero)),
        (1, Gen.Select(Gen.Float[-12, 12], Gen.Float[-12, 12], Gen.Float[-2, 10], (x, y, z) => new Vector3(x, y, z))),
        (1, Gen.Select(Gen.Float[-40, 40], Gen.Float[-40, 40], Gen.Float[-40, 40], (x, y, z) => new Vector3(x, y, z))));

    /// <summary>Ways to go at once, metres.</summary>
    internal static Gen<Vector3> Ways { get; } =
        Gen.Select(Gen.Float[0, 20], Gen.Float[-180, 180], Gen.Float[-6, 6], (length, direction, z) =>
        new Vector3(length * MathF.Cos(direction * MathF.PI / 180), length * MathF.Sin(direction * MathF.PI / 180), z));

    private static readonly Gen<Deed> AnyDeed = Gen.Select(
        Gen.Int[0, Held.Length - 1], Gen.Int[1, 40], Push, (keys, frames, push) => new Deed(Held[keys], frames, push));

    /// <summary>Trips from everywhere in the demo world.</summary>
    internal static Gen<Trip> Any { get; } = From([.. Enumerable.Range(0, DemoPlaces.All.Length)], 12);

    /// <summary>Trips that begin near one of some places.</summary>
    internal static Gen<Trip> From(int[] places, int mostDeeds) => Gen.Select(
        Gen.Frequency((5, Gen.Const(Traveller.Player)), (5, Gen.Enum<Traveller>())),
        Gen.Int[0, places.Length - 1].Select(i => places[i]),
        Gen.Select(
            Gen.Float[-6, 6], Gen.Float[-6, 6], Gen.Frequency((3, Gen.Const(0f)), (1, Gen.Float[0, 3])), (x, y, z) => new Vector3(x, y, z)),
        Gen.Float[0, 360], Gen.Select(Gen.Int[0, 800], Gen.Int[0, 800]), Gen.Frequency((5, Gen.Const(1)), (1, Gen.Int[2, 6])),
        AnyDeed.Array[1, mostDeeds],
        (who, place, offset, heading, skills, frame, deeds) =>
            new Trip(who, place, offset, heading, skills.Item1, skills.Item2, frame, deeds));

    public override string ToString() =>
        $"{Who} at {DemoPlaces.All[Place].Name} + {Offset} heading {Heading:R} run {RunSkill} jump {JumpSkill} " +
        $"frame {FrameTime}/30 s: {string.Join("; ", Deeds)}";
}
