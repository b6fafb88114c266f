using System.Numerics;
using Surefoot.Dats.Records;
using Surefoot.DemoWorld.Motions;
using static Surefoot.DemoWorld.Motions.MotionIds;

namespace Surefoot.DemoWorld.Human;

/// <summary>The human's motion table and animations: the style of peace, and that of bare fists.</summary>
/// <remarks>Velocities are retail's (specification 01, 3): walk 3.12, run 4.0, sidestep 1.25 m/s and turn 1.5 rad/s at speed 1.</remarks>
internal static class HumanMotions
{
    private const uint FirstAnimation = 0x03000001;

    private static readonly Vector3 WalkVelocity = new(0, 3.12f, 0), RunVelocity = new(0, 4f, 0), SideStepVelocity = new(1.25f, 0, 0),
        TurnOmega = new(0, 0, -1.5f);

    /// <summary>Table and animations.</summary>
    public static IEnumerable<DatRecord> All()
    {
        var animations = new AnimationList<HumanPose>(FirstAnimation);
        var sheet = new MotionSheet(DemoIds.HumanMotionTable, NonCombat) { Style = NonCombat };
        AddPeace(sheet, animations);
        sheet.Style = HandCombat;
        AddCombat(sheet, animations);
        return [sheet.ToRecord(), .. animations.Records];
    }

    private static void AddPeace(MotionSheet sheet, AnimationList<HumanPose> animations)
    {
        sheet.Cycle(Ready, CycleRule.None, animations.Cycle(60, HumanPoses.Ready));
        sheet.Cycle(Walk, CycleRule.None, animations.Cycle(24, HumanPoses.Walk), WalkVelocity);
        sheet.Cycle(Run, CycleRule.None, animations.Cycle(20, HumanPoses.Run), RunVelocity);
        sheet.Cycle(SideStep, CycleRule.OnlyFromDefault, animations.Cycle(20, HumanPoses.SideStep), SideStepVelocity);
        sheet.Cycle(Turn, CycleRule.OnlyFromDefault, animations.Cycle(16, HumanPoses.Turn), omega: TurnOmega);
        sheet.Cycle(Falling, CycleRule.None, animations.Cycle(20, HumanPoses.Falling));
        sheet.Cycle(Fallen, CycleRule.ClearsModifiers, animations.Still(HumanPoses.Fallen()));
        sheet.Cycle(Dead, CycleRule.ClearsModifiers, animations.Still(HumanPoses.Dead()));
        sheet.Cycle(Crouch, CycleRule.ClearsModifiers, animations.Cycle(60, HumanPoses.Crouch));
        sheet.Cycle(Sitting, CycleRule.ClearsModifiers, animations.Cycle(60, HumanPoses.Sitting));
        sheet.Cycle(Sleeping, CycleRule.ClearsModifiers, animations.Cycle(90, HumanPoses.Sleeping));
        AddSteps(sheet);
        AddGaitLinks(sheet, animations, HumanPoses.Ready(0), HumanPoses.Walk(0), HumanPoses.Run(0));

        // Every posture is left by way of Ready; who crouches and is to sit gets up in between.
        HumanPose ready = HumanPoses.Ready(0);
        sheet.Link(Ready, Dead, animations.Transition(20, ready, HumanPoses.Dead()));
        AddPosture(Fallen, HumanPoses.Fallen(), 12, 16);
        AddPosture(Crouch, HumanPoses.Crouch(0), 10, 10);
        AddPosture(Sitting, HumanPoses.Sitting(0), 18, 18);
        AddPosture(Sleeping, HumanPoses.Sleeping(0), 24, 24);
        sheet.Link(Ready, Wave, animations.Once(50, HumanPoses.Wave));
        sheet.Link(Ready, HandCombat, animations.Transition(8, ready, HumanPoses.Guard(0)));

        void AddPosture(uint posture, HumanPose pose, int down, int up)
        {
            sheet.Link(Ready, posture, animations.Transition(down, ready, pose));
            sheet.Link(posture, Ready, animations.Transition(up, pose, ready));
        }
    }

    // What has no cycle here (postures, lying dead) is found in the style of peace.
    private static void AddCombat(MotionSheet sheet, AnimationList<HumanPose> animations)
    {
        sheet.Cycle(Ready, CycleRule.None, animations.Cycle(40, HumanPoses.Guard));
        sheet.Cycle(Walk, CycleRule.None, animations.Cycle(24, HumanPoses.GuardWalk), WalkVelocity);
        sheet.Cycle(Run, CycleRule.None, animations.Cycle(20, HumanPoses.GuardRun), RunVelocity);
        sheet.Cycle(SideStep, CycleRule.OnlyFromDefault, animations.Cycle(20, HumanPoses.GuardSideStep), SideStepVelocity);
        sheet.Cycle(Turn, CycleRule.OnlyFromDefault, animations.Cycle(16, HumanPoses.GuardTurn), omega: TurnOmega);
        sheet.Cycle(Falling, CycleRule.None, animations.Cycle(20, HumanPoses.Falling));
        AddSteps(sheet);
        AddGaitLinks(sheet, animations, HumanPoses.Guard(0), HumanPoses.GuardWalk(0), HumanPoses.GuardRun(0));
        sheet.Link(Ready, Attack, animations.Once(22, HumanPoses.Punch));
        sheet.Link(Ready, Dead, animations.Transition(20, HumanPoses.Guard(0), HumanPoses.Dead()));
        sheet.Link(Ready, NonCombat, animations.Transition(8, HumanPoses.Guard(0), HumanPoses.Ready(0)));
    }

    private static void AddSteps(MotionSheet sheet)
    {
        sheet.Modifier(Turn, omega: TurnOmega);
        sheet.Modifier(SideStep, SideStepVelocity);
    }

    // Short, so that nothing seems to wait for them. The velocity is the coming cycle's from the first frame on.
    private static void AddGaitLinks(
        MotionSheet sheet, AnimationList<HumanPose> animations, HumanPose ready, HumanPose walk, HumanPose run)
    {
        HumanPose falling = HumanPoses.Falling(0);
        sheet.Link(Ready, Walk, animations.Transition(4, ready, walk));
        sheet.Link(Ready, Run, animations.Transition(4, ready, run));
        sheet.Link(Ready, Falling, animations.Transition(3, ready, falling));
        sheet.Link(Walk, Ready, animations.Transition(4, walk, ready));
        sheet.Link(Walk, Run, animations.Transition(3, walk, run));
        sheet.Link(Walk, Falling, animations.Transition(3, walk, falling));
        sheet.Link(Run, Ready, animations.Transition(5, run, ready));
        sheet.Link(Run, Walk, animations.Transition(3, run, walk));
        sheet.Link(Run, Falling, animations.Transition(3, run, falling));
        // Landing on the spot gives way in the knees.
        sheet.Link(Falling, Ready, animations.Transition(6, falling, HumanPoses.Landed(), ready));
        sheet.Link(Falling, Walk, animations.Transition(3, falling, walk));
        sheet.Link(Falling, Run, animations.Transition(3, falling, run));
    }
}
