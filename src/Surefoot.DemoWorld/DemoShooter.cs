using System.Collections.Immutable;
using System.Numerics;
using Surefoot.DemoWorld.Placement;

namespace Surefoot.DemoWorld;

/// <summary>Something of the demo world that shoots at intervals, as a server would have it do.</summary>
/// <param name="Name">Unique name in kebab-case.</param>
/// <param name="SetupId">Setup of what it shoots.</param>
/// <param name="CellId">The cell of its muzzle.</param>
/// <param name="Origin">The muzzle: metres from the south-west corner of the cell's block.</param>
/// <param name="Heading">Where it aims: degrees clockwise from north.</param>
/// <param name="Pitch">How far upwards it aims, degrees.</param>
/// <param name="Speed">m/s.</param>
/// <param name="Period">Seconds from one shot to the next.</param>
/// <param name="Falls">What it shoots has weight.</param>
public sealed record DemoShooter(
    string Name, uint SetupId, uint CellId, Vector3 Origin, float Heading, float Pitch, float Speed, float Period, bool Falls)
{
    /// <summary>Velocity of what it shoots, m/s, world axes.</summary>
    public Vector3 Velocity
    {
        get
        {
            var (sin, cos) = Math.SinCos(Heading * Math.PI / 180.0);
            var (up, ahead) = Math.SinCos(Pitch * Math.PI / 180.0);
            return new((float)(Speed * ahead * sin), (float)(Speed * ahead * cos), (float)(Speed * up));
        }
    }
}

/// <summary>What shoots in the demo world.</summary>
public static class DemoShooters
{
    private static readonly Lazy<ImmutableArray<DemoShooter>> Default = new(() => WorldPlan.Create(DemoWorldBuilder.DefaultSeed).Shooters);

    /// <summary>Those of the world that <see cref="DemoWorldBuilder.DefaultSeed"/> makes.</summary>
    public static ImmutableArray<DemoShooter> All => Default.Value;
}
