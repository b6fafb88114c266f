namespace Surefoot.Physics.Bodies;

/// <summary>A hook of an animation that a body has passed; what it says is in the record of the animation.</summary>
/// <param name="AnimationId">The animation, 0x03….</param>
/// <param name="Frame">The frame that has it, from 0.</param>
/// <param name="Index">Its place among the hooks of the frame, from 0.</param>
public readonly record struct PassedHook(uint AnimationId, int Frame, int Index);

/// <summary>
/// Is told of every hook that a body's animations pass: sounds, attacks, lights and whatever else a record holds, each once, in the order
/// passed. What matters to movement is done by then. Called inside a quantum: it may set velocities but must not move bodies.
/// </summary>
/// <remarks>Retail: CPhysicsObj::process_hooks @0x00511550; specification 01b, 1, and 02, 4.18.</remarks>
public interface IHookListener
{
    /// <summary>The body passed a hook.</summary>
    void OnHook(PhysicsBody body, in PassedHook hook);
}
