using System.Collections.Immutable;
using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Human;

/// <summary>Makes animation records and hands out their ids, in the order of the calls.</summary>
internal sealed class AnimationList
{
    private const uint FirstId = 0x03000001;

    private readonly List<Animation> records = [];

    /// <summary>The animations made so far.</summary>
    public IReadOnlyList<Animation> Records => records;

    /// <summary>An animation that goes round.</summary>
    /// <param name="frames">How many frames a round has.</param>
    /// <param name="pose">The pose at a phase, 0 to 1.</param>
    /// <returns>Its id.</returns>
    public uint Cycle(int frames, Func<double, HumanPose> pose)
        => Add(Enumerable.Range(0, frames).Select(i => pose((double)i / frames)));

    /// <summary>An animation of one pose.</summary>
    public uint Still(HumanPose pose) => Add([pose]);

    /// <summary>An animation from one pose to another, neither included.</summary>
    public uint Transition(int frames, HumanPose from, HumanPose to)
        => Add(Enumerable.Range(1, frames).Select(i => HumanPose.Between(from, to, i / (frames + 1.0))));

    private uint Add(IEnumerable<HumanPose> poses)
    {
        uint id = FirstId + (uint)records.Count;
        ImmutableArray<AnimFrame> frames = [.. poses.Select(pose => pose.ToFrame())];
        records.Add(new() { Id = id, PartCount = HumanPose.PartCount, Frames = frames });
        return id;
    }
}
