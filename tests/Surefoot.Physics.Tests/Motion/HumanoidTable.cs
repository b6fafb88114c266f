using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Motion;

namespace Surefoot.Physics.Tests.Motion;

/// <summary>A humanoid's motions with retail's velocities, either in animations of 30 frames a second or without any.</summary>
internal static class HumanoidTable
{
    internal const MotionCommand Bow = (MotionCommand)0x1000007D;
    internal const byte OnlyFromDefault = 2;

    internal static readonly AnimationAsset TenFrames = new(0x03000001, 10);

    internal static MotionTableAsset Create(bool smooth = false, bool links = false)
    {
        MotionAsset Data(Vector3 velocity = default, Vector3 omega = default, byte bits = 0) =>
            new(smooth ? [] : [new AnimationSpan(TenFrames, 0, -1, 30f)], velocity, omega, bits);

        MotionTableBuilder table = new MotionTableBuilder(0x09000001)
            .Style(MotionCommand.NonCombat, MotionCommand.Ready)
            .Cycle(MotionCommand.NonCombat, MotionCommand.Ready, Data())
            .Cycle(MotionCommand.NonCombat, MotionCommand.WalkForward, Data(new Vector3(0, 3.12f, 0)))
            .Cycle(MotionCommand.NonCombat, MotionCommand.RunForward, Data(new Vector3(0, 4f, 0)))
            .Cycle(MotionCommand.NonCombat, MotionCommand.SideStepRight, Data(new Vector3(1.25f, 0, 0), bits: OnlyFromDefault))
            .Cycle(MotionCommand.NonCombat, MotionCommand.TurnRight, Data(omega: new Vector3(0, 0, -1.5f), bits: OnlyFromDefault))
            .Cycle(MotionCommand.NonCombat, MotionCommand.Falling, Data())
            .Cycle(MotionCommand.NonCombat, MotionCommand.Dead, Data())
            .Cycle(MotionCommand.NonCombat, MotionCommand.Crouch, Data())
            .Modifier(MotionCommand.NonCombat, MotionCommand.SideStepRight, Data(new Vector3(1.25f, 0, 0)))
            .Modifier((uint)MotionCommand.TurnRight & MotionCommands.KeyMask, Data(omega: new Vector3(0, 0, -1.5f)));
        if (links)
        {
            MotionAsset link = new([new AnimationSpan(new AnimationAsset(0x03000002, 6), 0, -1, 30f)]);
            foreach (MotionCommand motion in (MotionCommand[])[MotionCommand.WalkForward, MotionCommand.RunForward])
            {
                table.Link(MotionCommand.NonCombat, MotionCommand.Ready, motion, link);
                table.Link(MotionCommand.NonCombat, motion, MotionCommand.Ready, link);
            }

            table.Link(MotionCommand.NonCombat, MotionCommand.Ready, Bow, link);
        }

        return table.Build();
    }
}
