namespace Surefoot.Physics.Transitions;

/// <summary>What a sphere path is for.</summary>
internal enum InsertType
{
    /// <summary>A body moves.</summary>
    Transition = 0,

    /// <summary>A body is put somewhere and must not overlap anything solid.</summary>
    Placement = 1,

    /// <summary>First look at a place: the environment only, and rooms push the body out.</summary>
    InitialPlacement = 2,
}

/// <summary>Who moves, as bits (retail: OBJECTINFO::state).</summary>
[Flags]
internal enum MoverFlags
{
    /// <summary>Nothing special.</summary>
    None = 0,

    /// <summary>Touches a contact plane.</summary>
    Contact = 0x1,

    /// <summary>Stands on a plane that can be walked on.</summary>
    OnWalkable = 0x2,

    /// <summary>The camera.</summary>
    IsViewer = 0x4,

    /// <summary>Ends its sweep at the first collision: missiles and the camera.</summary>
    PathClipped = 0x8,

    /// <summary>Takes the final orientation at once.</summary>
    FreeRotate = 0x10,

    /// <summary>Stops exactly at contact (the camera).</summary>
    PerfectClip = 0x40,

    /// <summary>Stops even players that would pass.</summary>
    IsImpenetrable = 0x80,

    /// <summary>A player.</summary>
    IsPlayer = 0x100,

    /// <summary>Slides along edges instead of walking off.</summary>
    EdgeSlide = 0x200,

    /// <summary>Passes creatures.</summary>
    IgnoreCreatures = 0x400,

    /// <summary>A player killer.</summary>
    IsPK = 0x800,

    /// <summary>A player killer lite.</summary>
    IsPKLite = 0x1000,
}
