namespace Surefoot.Physics.Decisions;

/// <summary>What an entry of a trace tells.</summary>
public enum TraceKind : byte
{
    /// <summary>Nothing: an empty entry.</summary>
    None,

    /// <summary>A sweep or a placement begins. <see cref="TraceEntry.Offset"/> is the whole way asked for.</summary>
    SweepBegins,

    /// <summary>
    /// A sweep or a placement is over. <see cref="TraceEntry.Succeeded"/> says whether a valid place was found; the subject and the plane
    /// are what the body rests on there.
    /// </summary>
    SweepEnds,

    /// <summary>
    /// A sub-step begins. <see cref="TraceEntry.Offset"/> is its share of the way, before it is bent; the subject and the plane are what
    /// the body rests on.
    /// </summary>
    SubStepBegins,

    /// <summary>
    /// A sub-step is over: accepted, or refused and taken back. The subject and the plane are what the body rests on now.
    /// </summary>
    SubStepEnds,

    /// <summary>
    /// A sub-step was bent before it was tried. <see cref="TraceEntry.Offset"/> is what became of it, and the normal is that of what it was
    /// bent along.
    /// </summary>
    Bent,

    /// <summary>The position was lifted out of the plane it had sunk into, by <see cref="TraceEntry.Offset"/>.</summary>
    Lifted,

    /// <summary>The centre of the foot is in another cell now.</summary>
    CellEntered,

    /// <summary>A cell answered the position under test.</summary>
    CellAnswered,

    /// <summary>An object in the cell was not asked, and why.</summary>
    Skipped,

    /// <summary>An object in the cell was asked and answered.</summary>
    ObjectAnswered,

    /// <summary>A sphere met a polygon, a cylinder, a ball or the ground. <see cref="TraceEntry.Gap"/> is how far it is from it.</summary>
    Hit,

    /// <summary>The body rests on a plane from now on.</summary>
    ContactPlane,

    /// <summary>
    /// A response that asks further questions is being tried; what follows up to its <see cref="Responded"/> belongs to it.
    /// </summary>
    Tried,

    /// <summary>A response found a way, or did not, and why.</summary>
    Responded,
}

/// <summary>The ways a transition answers an obstacle or a missing floor.</summary>
public enum TransitionResponse : byte
{
    /// <summary>None.</summary>
    None,

    /// <summary>Onto an obstacle.</summary>
    StepUp,

    /// <summary>Down to keep the ground.</summary>
    StepDown,

    /// <summary>Along a wall.</summary>
    Slide,

    /// <summary>Along or off an edge.</summary>
    EdgeSlide,

    /// <summary>Along a slope too steep to walk on.</summary>
    CliffSlide,

    /// <summary>Along the edge of the polygon walked on.</summary>
    PrecipiceSlide,

    /// <summary>A landing is confirmed or refused.</summary>
    Landing,

    /// <summary>Stopped where it met something.</summary>
    Stop,
}

/// <summary>What the world is asked about a position.</summary>
public enum SweepQuestion : byte
{
    /// <summary>May the body move there?</summary>
    Move,

    /// <summary>Where does it come to rest on what it met in the air?</summary>
    Land,

    /// <summary>Is there footing above, on what blocks?</summary>
    StepUp,

    /// <summary>Is there footing below?</summary>
    StepDown,

    /// <summary>Does the footing support the foot?</summary>
    Footing,

    /// <summary>Is there room?</summary>
    Place,

    /// <summary>Is there room among walls and floors, if it may be pushed out of them?</summary>
    FirstPlace,
}
