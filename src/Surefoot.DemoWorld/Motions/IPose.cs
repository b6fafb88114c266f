using Surefoot.Dats.Records;

namespace Surefoot.DemoWorld.Motions;

/// <summary>How the parts of a body are held.</summary>
/// <typeparam name="TSelf">The kind of body.</typeparam>
internal interface IPose<TSelf>
    where TSelf : struct, IPose<TSelf>
{
    /// <summary>Number of parts.</summary>
    static abstract int PartCount { get; }

    /// <summary>A pose between two: share 0 gives the first, 1 the second.</summary>
    static abstract TSelf Between(TSelf a, TSelf b, double share);

    /// <summary>Where the parts are, in object coordinates: x right, y forward, z up from between the feet.</summary>
    AnimFrame ToFrame();
}
