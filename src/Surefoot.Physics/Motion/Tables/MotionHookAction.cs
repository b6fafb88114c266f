using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;

namespace Surefoot.Physics.Motion;

/// <summary>Hooks and what they act on.</summary>
internal static class MotionHookAction
{
    /// <summary>Does to an object what a hook says; the end of an animation is nothing to the object itself.</summary>
    /// <remarks>Retail: the Execute methods of the CAnimHook family.</remarks>
    internal static void ActOn(in this MotionHook hook, IHookTarget target)
    {
        switch (hook.Kind)
        {
            case MotionHookKind.Ethereal: target.SetEthereal(hook.Value.X != 0); break;
            case MotionHookKind.Omega: target.SetOmega(hook.Value); break;
            case MotionHookKind.Scale: target.SetScale(hook.Value.X, hook.Value.Y); break;
        }

        if (hook.Kind != MotionHookKind.AnimationDone) target.OnPassed(new PassedHook(hook.AnimationId, hook.Frame, hook.Index));
    }
}
