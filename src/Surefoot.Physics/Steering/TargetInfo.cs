using System.Numerics;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Steering;

/// <summary>What became of a tracked object; the numbers are retail's, of which the client uses these.</summary>
internal enum TargetStatus
{
    /// <summary>Nothing was heard of it yet.</summary>
    Undefined = 0,

    /// <summary>It is there.</summary>
    OK = 1,

    /// <summary>It left the world.</summary>
    LeftWorld = 2,

    /// <summary>It was teleported.</summary>
    Teleported = 3,

    /// <summary>Nothing was heard of it for ten seconds.</summary>
    TimedOut = 6,
}

/// <summary>What a body knows of the object it tracks, and a report about it.</summary>
/// <remarks>Retail: TargetInfo @0x0051A420; specification 09b, 7.1.</remarks>
internal struct TargetInfo
{
    /// <summary>Who asked; only 0 reaches the managers.</summary>
    internal uint ContextId;

    /// <summary>The object.</summary>
    internal uint ObjectId;

    /// <summary>How far it may get before it is reported again, metres.</summary>
    internal float Radius;

    /// <summary>How far ahead its place is foretold, seconds.</summary>
    internal double Quantum;

    /// <summary>Where it is.</summary>
    internal Position TargetPosition;

    /// <summary>Where it will be.</summary>
    internal Position InterpolatedPosition;

    /// <summary>Unit vector towards where it will be, or up when that is here.</summary>
    internal Vector3 InterpolatedHeading;

    /// <summary>Its velocity, m/s, world axes.</summary>
    internal Vector3 Velocity;

    /// <summary>What became of it.</summary>
    internal TargetStatus Status;

    /// <summary>When it was last heard of, seconds of the frame's clock.</summary>
    internal double LastUpdate;
}
