using Surefoot.Physics.World;

namespace Surefoot.Server;

/// <summary>What a person wants a creature to do.</summary>
public enum CreatureWish : byte
{
    /// <summary>What it likes.</summary>
    AsItLikes = 0,

    /// <summary>Follow the player.</summary>
    Follow = 1,

    /// <summary>Flee from the player.</summary>
    Flee = 2,

    /// <summary>Stand where it is.</summary>
    Stand = 3,
}

/// <summary>
/// The wits of a creature: it stands a while, goes to a place near its home, and stands again; or it does what a person wants. How it gets
/// there, and whether, is up to its driver.
/// </summary>
/// <param name="driver">Its driver.</param>
/// <param name="home">The middle of where it strays.</param>
/// <param name="radius">How far it strays, metres; 0 for one that stays at home.</param>
/// <param name="onGround">Puts a place on the ground; null where there is none.</param>
/// <param name="seed">Of its ways.</param>
public sealed class CreatureMind(
    CreatureDriver driver, Position home, float radius, Func<Position, Position?> onGround, ulong seed)
{
    private const double LeastPause = 1, LongestPause = 5;

    /// <summary>One that stays at home goes back there from farther away than this, metres.</summary>
    private const double AtHome = 0.5;

    private CreatureWish wish;
    private bool isUnderWay;
    private ulong rolls = seed;
    private double until = double.NaN;

    /// <summary>What it does at a person's wish; what it likes when that came to nothing.</summary>
    public CreatureWish Wish => wish;

    /// <summary>It is to do something else from now on.</summary>
    /// <param name="wanted">What.</param>
    /// <param name="player">Id of the player who wants it.</param>
    /// <param name="now">Seconds.</param>
    public void Ask(CreatureWish wanted, uint player, double now)
    {
        if (!driver.Body.HasCell) return;
        wish = wanted switch
        {
            CreatureWish.Follow when driver.Follow(player) => CreatureWish.Follow,
            CreatureWish.Flee when driver.FleeFrom(player) => CreatureWish.Flee,
            CreatureWish.Stand => CreatureWish.Stand,
            _ => CreatureWish.AsItLikes,
        };
        if (wish is CreatureWish.Stand or CreatureWish.AsItLikes) driver.Stop();
        until = now;
    }

    /// <summary>Decides what to do next; before the world's tick.</summary>
    /// <param name="now">Seconds.</param>
    public void Act(double now)
    {
        if (!driver.Body.HasCell || wish == CreatureWish.Stand) return;
        if (double.IsNaN(until)) until = now + (LongestPause * Roll());
        // Whom it follows or flees from may go away.
        if (wish != CreatureWish.AsItLikes && driver.Goal == CreatureGoal.None) wish = CreatureWish.AsItLikes;
        if (wish != CreatureWish.AsItLikes) return;
        if (driver.Progress == CreatureProgress.Stuck) driver.Stop();
        if (driver.Progress != CreatureProgress.Idle)
        {
            isUnderWay = true;
            return;
        }

        if (isUnderWay) until = now + LeastPause + ((LongestPause - LeastPause) * Roll());
        isUnderWay = false;
        if (now >= until) Choose();
    }

    /// <summary>After the world's tick.</summary>
    public void LookOn() => driver.Update();

    private void Choose()
    {
        if (radius == 0)
        {
            if (driver.Body.Position.DistanceTo(home) > AtHome) driver.GoHome();
            return;
        }

        double way = radius * Math.Sqrt(Roll()), direction = Math.Tau * Roll();
        Position target = home;
        target.Frame.Origin.X += (float)(way * Math.Sin(direction));
        target.Frame.Origin.Y += (float)(way * Math.Cos(direction));
        if (onGround(target) is { } place) driver.MoveTo(place);
    }

    /// <summary>A number in [0, 1) from the creature's own seed (SplitMix64).</summary>
    private double Roll()
    {
        rolls += 0x9E3779B97F4A7C15;
        ulong z = rolls;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
        return ((z ^ (z >> 31)) >> 11) * (1.0 / (1UL << 53));
    }
}
