using System.Numerics;

namespace Surefoot.Physics.Bodies;

/// <summary>What an animation does to its object besides moving it: a body, or a static that its default animation moves.</summary>
/// <remarks>Retail: the members of CPhysicsObj that the CAnimHook family calls; specification 02, 4.18.</remarks>
internal interface IHookTarget
{
    /// <summary>Lets others through, or is solid again as soon as nothing overlaps it; false when it has to wait.</summary>
    bool SetEthereal(bool on);

    /// <summary>Turns by itself, rad/s, world axes.</summary>
    void SetOmega(Vector3 value);

    /// <summary>Grows or shrinks, at once or in a number of seconds.</summary>
    void SetScale(float value, float seconds);

    /// <summary>A hook of an animation was passed and what it does to the object is done.</summary>
    void OnPassed(in PassedHook hook)
    {
    }
}
