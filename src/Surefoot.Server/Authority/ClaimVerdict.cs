using Surefoot.Physics.World;

namespace Surefoot.Server;

/// <summary>What becomes of a player's claim.</summary>
public enum ClaimOutcome
{
    /// <summary>It is so.</summary>
    Accepted,

    /// <summary>It is nearly so: the player is to be put to the verdict's place, a little beside the one claimed.</summary>
    Corrected,

    /// <summary>It is not so: the player is to be put to the verdict's place, which is where it was before.</summary>
    Refused,
}

/// <summary>Why a claim was not accepted.</summary>
public enum ClaimReason
{
    /// <summary>It was.</summary>
    None,

    /// <summary>A number is not finite, an orientation is none, or a speed is one that no key and no pointer asks for.</summary>
    BadNumber,

    /// <summary>It was sent before the player knew of its last life, teleport or correction.</summary>
    StaleSequence,

    /// <summary>Nothing is loaded there, so nothing is known of it.</summary>
    NotLoaded,

    /// <summary>It is so far away that no motion leads there.</summary>
    Teleport,

    /// <summary>The motions lead there, but not so soon.</summary>
    TooFast,

    /// <summary>Something is in the way: a wall, a step too high, a closed door.</summary>
    ThroughWall,

    /// <summary>It is higher than the jump goes.</summary>
    TooHigh,

    /// <summary>It says to stand where there is no ground, or it is in the air for longer than gravity allows.</summary>
    InTheAir,

    /// <summary>Nothing is in the way, but the motions told do not lead there.</summary>
    OffCourse,

    /// <summary>The jump is higher or farther than skill, load and charge allow.</summary>
    JumpTooHigh,

    /// <summary>The jump begins where there is no ground.</summary>
    JumpInTheAir,

    /// <summary>The jump would be right for one who is not exhausted.</summary>
    JumpWithoutStamina,
}

/// <summary>A verdict on a claim.</summary>
/// <param name="Outcome">What becomes of it.</param>
/// <param name="Reason">Why it was not accepted.</param>
/// <param name="Position">Where the player is from now on.</param>
/// <param name="Miss">How far from the place claimed the motions told lead at best, metres.</param>
public readonly record struct ClaimVerdict(ClaimOutcome Outcome, ClaimReason Reason, Position Position, float Miss = 0)
{
    /// <summary>It is so.</summary>
    public bool IsAccepted => Outcome == ClaimOutcome.Accepted;
}
