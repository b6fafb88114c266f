namespace Surefoot.Physics.Bodies;

/// <summary>The changing bits of a body (specification 02, 2.3).</summary>
[Flags]
public enum TransientState : uint
{
    /// <summary>No bit.</summary>
    None = 0,

    /// <summary>Touches a plane.</summary>
    Contact = 0x1,

    /// <summary>Stands on a plane that can be walked on.</summary>
    OnWalkable = 0x2,

    /// <summary>Slides along a wall.</summary>
    Sliding = 0x4,

    /// <summary>The plane is water, or another body.</summary>
    WaterContact = 0x8,

    /// <summary>Failed to move once.</summary>
    StationaryFall = 0x10,

    /// <summary>Failed to move twice.</summary>
    StationaryStop = 0x20,

    /// <summary>Failed to move three times; accepted as a seed, never set.</summary>
    StationaryStuck = 0x40,

    /// <summary>Is being simulated.</summary>
    Active = 0x80,

    /// <summary>Wants to become solid as soon as nothing overlaps.</summary>
    CheckEthereal = 0x100,

    /// <summary>The three counters of failed moves.</summary>
    StationaryMask = StationaryFall | StationaryStop | StationaryStuck,
}
