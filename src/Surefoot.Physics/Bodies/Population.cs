using Surefoot.Physics.Transitions;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <summary>
/// The bodies of one engine and what they share: the cells they move through, the time, the player, the work objects, the dice.
/// </summary>
internal sealed class Population
{
    private readonly Func<PhysicsBody, IBodyDriver> makeDriver;
    private ulong rollState;

    /// <summary>Nobody yet.</summary>
    /// <param name="cells">The cells bodies move through.</param>
    /// <param name="seed">Seed of scattered placements; part of the state.</param>
    /// <param name="makeDriver">Makes what drives a body.</param>
    internal Population(ICellWorld cells, ulong seed, Func<PhysicsBody, IBodyDriver> makeDriver)
    {
        Cells = cells;
        Transitions = new TransitionPool(cells);
        rollState = seed;
        this.makeDriver = makeDriver;
    }

    /// <summary>The bodies, in the order in which they are updated.</summary>
    internal BodyTable Bodies { get; } = new();

    /// <summary>The cells bodies move through.</summary>
    internal ICellWorld Cells { get; }

    /// <summary>Time of the last tick, seconds.</summary>
    internal double Now { get; set; }

    /// <summary>The local player, or null.</summary>
    internal PhysicsBody? Player { get; set; }

    /// <summary>A body stays where it is when a move would end in no loaded cell.</summary>
    internal bool RefuseLeavingCells { get; set; }

    /// <summary>The work objects of those who change bodies, one thread at a time.</summary>
    internal TransitionPool Transitions { get; }

    /// <summary>The body with this id, or null.</summary>
    internal PhysicsBody? Find(uint id) => Bodies.Find(id);

    /// <summary>Refuses a body of another engine.</summary>
    /// <exception cref="ArgumentException">It is one.</exception>
    internal void ThrowIfForeign(PhysicsBody body)
    {
        ArgumentNullException.ThrowIfNull(body);
        if (!ReferenceEquals(body.Population, this)) throw new ArgumentException("The body belongs to another engine.", nameof(body));
    }

    /// <summary>What drives a new body.</summary>
    internal IBodyDriver MakeDriver(PhysicsBody body) => makeDriver(body);

    /// <summary>A number in [-1, 1] from the engine's own seed.</summary>
    internal double NextRoll()
    {
        // SplitMix64: the generator is not retail's, whose rolls come from the C library.
        rollState += 0x9E3779B97F4A7C15;
        ulong z = rollState;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
        z ^= z >> 31;
        return ((z >> 11) * (2.0 / ((1UL << 53) - 1))) - 1.0;
    }

    /// <summary>Adds the state of the dice and of every body to a hash.</summary>
    internal void AddTo(ref StateHash hash)
    {
        hash.Add(rollState);
        foreach (PhysicsBody body in Bodies) body.AddTo(ref hash);
    }
}
