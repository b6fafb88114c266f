using Surefoot.Physics.World;

namespace Surefoot.Physics.Queries;

/// <summary>A place to be put at: <c>SetPosition</c> of retail's bodies.</summary>
/// <param name="Mover">Who is put there.</param>
/// <param name="Position">Where; the cell is put right first.</param>
/// <param name="Slides">A free place near by will do, at most 4 m away; else exactly there or not at all.</param>
public readonly record struct PlaceInput(Mover Mover, Position Position, bool Slides = true);

/// <summary>Where a mover can be put.</summary>
/// <param name="Found">There is room.</param>
/// <param name="IsLoaded">False when the place is where no cell is loaded: nothing is known of what is there.</param>
/// <param name="Position">Where it would be; the place asked about when there is no room.</param>
/// <param name="Contact">What it stands on there, or null: floor within its step-down height is gone down to.</param>
public readonly record struct PlaceResult(bool Found, bool IsLoaded, Position Position, Contact? Contact);

/// <summary>A way straight down, until something is touched.</summary>
/// <param name="Mover">Who is let down.</param>
/// <param name="From">Where it begins; the cell is put right first.</param>
/// <param name="Depth">How far down at most, metres, more than 0.</param>
public readonly record struct ProbeDownInput(Mover Mover, Position From, float Depth);

/// <summary>What is below.</summary>
/// <param name="Found">Something is touched on the way down.</param>
/// <param name="IsLoaded">False when the way begins, or ends, where no cell is loaded.</param>
/// <param name="Position">Where the mover is then; without anything to touch, all the way down.</param>
/// <param name="Depth">How far down that is, metres; a little less than 0 for one that is lifted out of the ground it begins in.</param>
/// <param name="Contact">
/// What it rests on; null when nothing was found, or when what stops it is nothing to rest on, such as a creature's head.
/// </param>
/// <param name="Subject">What that is.</param>
public readonly record struct ProbeDownResult(
    bool Found, bool IsLoaded, Position Position, float Depth, Contact? Contact, Decisions.TraceSubject Subject);
