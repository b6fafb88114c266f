using System.Collections.Immutable;
using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Motions;

/// <summary>Makes animation records of one kind of body and hands out their ids, in the order of the calls.</summary>
/// <typeparam name="TPose">How such a body is held.</typeparam>
/// <param name="firstId">Id of the first one.</param>
internal sealed class AnimationList<TPose>(uint firstId)
    where TPose : struct, IPose<TPose>
{
    private readonly List<Animation> records = [];

    /// <summary>The animations made so far.</summary>
    public IReadOnlyList<Animation> Records => records;

    /// <summary>An animation that goes round.</summary>
    /// <param name="frames">How many frames a round has.</param>
    /// <param name="pose">The pose at a phase, 0 to 1.</param>
    /// <returns>Its id.</returns>
    public uint Cycle(int frames, Func<double, TPose> pose) => Add(Enumerable.Range(0, frames).Select(i => pose((double)i / frames)));

    /// <summary>An animation of one pose.</summary>
    public uint Still(TPose pose) => Add([pose]);

    /// <summary>An animation that is played once; its beginning and its end, the poses before and after it, are not in it.</summary>
    /// <param name="frames">How many frames it has.</param>
    /// <param name="pose">The pose at a phase, 0 to 1.</param>
    public uint Once(int frames, Func<double, TPose> pose)
        => Add(Enumerable.Range(1, frames).Select(i => pose(i / (frames + 1.0))));

    /// <summary>An animation from one pose over others to the last, the first and the last not included.</summary>
    public uint Transition(int frames, params TPose[] poses)
        => Once(frames, phase =>
        {
            double place = phase * (poses.Length - 1);
            int from = Math.Min((int)place, poses.Length - 2);
            return TPose.Between(poses[from], poses[from + 1], place - from);
        });

    private uint Add(IEnumerable<TPose> poses)
    {
        uint id = firstId + (uint)records.Count;
        ImmutableArray<AnimFrame> frames = [.. poses.Select(pose => pose.ToFrame())];
        records.Add(new() { Id = id, PartCount = (uint)TPose.PartCount, Frames = frames });
        return id;
    }
}
