namespace Surefoot.Physics.World;

/// <summary>The physics state word of an object, as the wire and the dat files have it (specification 02, 2.2).</summary>
[Flags]
public enum PhysicsState : uint
{
    /// <summary>No bit.</summary>
    None = 0,

    /// <summary>Never moves; a hit on it counts as environment.</summary>
    Static = 0x1,

    /// <summary>Lets others through.</summary>
    Ethereal = 0x4,

    /// <summary>Collisions are reported.</summary>
    ReportCollisions = 0x8,

    /// <summary>Is not reported as a partner; with <see cref="Ethereal"/> it is not tested at all.</summary>
    IgnoreCollisions = 0x10,

    /// <summary>Not drawn.</summary>
    NoDraw = 0x20,

    /// <summary>A missile: no step down, ends its sweep at the first hit.</summary>
    Missile = 0x40,

    /// <summary>Unused by movement.</summary>
    Pushable = 0x80,

    /// <summary>Turns along its way each quantum.</summary>
    AlignPath = 0x100,

    /// <summary>Cleared together with <see cref="Missile"/>.</summary>
    PathClipped = 0x200,

    /// <summary>Falls.</summary>
    Gravity = 0x400,

    /// <summary>Has lights.</summary>
    LightingOn = 0x800,

    /// <summary>Emits particles.</summary>
    ParticleEmitter = 0x1000,

    /// <summary>Neither animated nor integrated.</summary>
    Hidden = 0x4000,

    /// <summary>Plays a script on collisions.</summary>
    ScriptedCollision = 0x8000,

    /// <summary>Collides by the BSP trees of its parts.</summary>
    HasPhysicsBsp = 0x10000,

    /// <summary>Stops where others bounce.</summary>
    Inelastic = 0x20000,

    /// <summary>An animated static.</summary>
    HasDefaultAnim = 0x40000,

    /// <summary>A scripted static.</summary>
    HasDefaultScript = 0x80000,

    /// <summary>Cloaked.</summary>
    Cloaked = 0x100000,

    /// <summary>A collision with it is reported as environment.</summary>
    ReportCollisionsAsEnvironment = 0x200000,

    /// <summary>Slides along edges instead of walking off.</summary>
    EdgeSlide = 0x400000,

    /// <summary>A sled: gravity and its own friction while standing.</summary>
    Sledding = 0x800000,

    /// <summary>Never updated.</summary>
    Frozen = 0x1000000,

    /// <summary>What new objects have: edge slide, lighting, gravity, report collisions.</summary>
    Default = EdgeSlide | LightingOn | Gravity | ReportCollisions,
}

/// <summary>Bit tests that cost nothing in any build; <c>Enum.HasFlag</c> boxes until the code is optimised.</summary>
internal static class PhysicsStateExtensions
{
    /// <summary>Is any of the bits set?</summary>
    [System.Runtime.CompilerServices.MethodImpl(System.Runtime.CompilerServices.MethodImplOptions.AggressiveInlining)]
    internal static bool Has(this PhysicsState state, PhysicsState bits) => (state & bits) != 0;
}
