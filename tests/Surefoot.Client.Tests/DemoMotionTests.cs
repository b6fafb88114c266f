using System.Numerics;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.World;

namespace Surefoot.Client.Tests;

/// <summary>
/// The demo world's humans and creatures, with motion tables, setups and animations as its files have them: stances, postures, actions.
/// </summary>
public sealed class DemoMotionTests(DemoFiles files) : IClassFixture<DemoFiles>
{
    private const double FrameTime = (1.0 / 30) + 1e-9;
    private const MotionCommand Attack = (MotionCommand)0x10000063;

    private readonly PhysicsEngine engine = files.CreateEngine();
    private int frames;

    [Theory, Behaviour("demo-world.motions.postures", "spec/01b, 2, rule 2; spec/01, 2.1")]
    [InlineData(MotionCommand.Crouch, 10)]
    [InlineData(MotionCommand.Sitting, 18)]
    [InlineData(MotionCommand.Sleeping, 24)]
    [InlineData(MotionCommand.Fallen, 12)]
    public void A_human_goes_down_over_a_link_stays_and_gets_up_again(MotionCommand posture, int linkFrames)
    {
        (PhysicsBody body, MovementManager movement) = Spawn(DemoIds.HumanSetup);
        Vector3 place = body.Position.Frame.Origin;
        Do(movement, posture);
        AnimationAsset link = movement.Animation!.CurrentAnimation!;
        Tick(linkFrames / 2);
        link = movement.Animation.CurrentAnimation!;
        Assert.Equal(linkFrames, link.FrameCount);
        Assert.True(movement.MotionsPending);
        Tick(linkFrames);
        Assert.NotSame(link, movement.Animation.CurrentAnimation);
        Assert.Equal((posture, false), (movement.Animation.Substate, movement.MotionsPending));
        Tick(120);
        Assert.Equal(posture, movement.Animation.Substate);

        Do(movement, MotionCommand.Ready);
        Tick(60);
        Assert.Equal((MotionCommand.Ready, false), (movement.Animation.Substate, movement.MotionsPending));
        Assert.Equal(place, body.Position.Frame.Origin);
    }

    [Fact, Behaviour("demo-world.motions.from-posture-to-posture", "spec/01b, 2, rule 2: no link leads by way of the default substate")]
    public void Who_sits_and_is_to_crouch_gets_up_in_between()
    {
        (_, MovementManager movement) = Spawn(DemoIds.HumanSetup);
        Do(movement, MotionCommand.Sitting);
        Tick(60);
        int before = movement.Animation!.Sequence.Count;
        Do(movement, MotionCommand.Crouch);
        // Up, down, and the cycle; the old cycle went.
        Assert.Equal(before + 2, movement.Animation.Sequence.Count);
        Tick(60);
        Assert.Equal(MotionCommand.Crouch, movement.Animation.Substate);
    }

    [Fact, Behaviour("demo-world.motions.postures-forbid-jumping", "spec/01, 4.12, motion_allows_jump")]
    public void Who_sits_cannot_jump_and_who_stands_up_can()
    {
        (_, MovementManager movement) = Spawn(DemoIds.HumanSetup, new PlayerWeenie(new CharacterStats(300, 300)));
        Do(movement, MotionCommand.Sitting);
        Tick(60);
        Assert.Equal(MotionError.CannotJumpFromThisPosition, movement.Interpreter.ChargeJump());
        Do(movement, MotionCommand.Ready);
        Tick(60);
        Assert.Equal(MotionError.None, movement.Interpreter.ChargeJump());
    }

    [Fact, Behaviour("demo-world.motions.wave", "spec/01b, 2, rule 3; 3: an action at the head is removed")]
    public void A_human_waves_once_and_stands_as_before()
    {
        (_, MovementManager movement) = Spawn(DemoIds.HumanSetup);
        Assert.Equal(MotionError.None, movement.DoMotion(MotionCommand.Wave, new MovementParameters()));
        Tick(25);
        Assert.Equal(50, movement.Animation!.CurrentAnimation!.FrameCount);
        Assert.Equal((MotionCommand.Ready, 1), (movement.Animation.Substate, movement.Animation.State.ActionCount));
        Tick(60);
        Assert.Equal(60, movement.Animation.CurrentAnimation!.FrameCount);
        Assert.Equal((0, false), (movement.Animation.State.ActionCount, movement.MotionsPending));
    }

    [Fact, Behaviour("demo-world.motions.wave-on-the-way", "spec/01b, 2, rule 3: by way of the default substate and back to the cycle")]
    public void A_human_who_walks_waves_on_the_way_and_walks_on()
    {
        (PhysicsBody body, MovementManager movement) = Spawn(DemoIds.HumanSetup);
        Do(movement, MotionCommand.WalkForward);
        Tick(30);
        Assert.Equal(MotionError.None, movement.DoMotion(MotionCommand.Wave, new MovementParameters()));
        float before = body.Position.Frame.Origin.Y;
        Tick(90);
        // The velocity is the cycle's throughout; the links hand it out with their own frames.
        Assert.Equal(3 * 3.12f, body.Position.Frame.Origin.Y - before, 0.25f);
        Assert.Equal((MotionCommand.WalkForward, 0), (movement.Animation!.Substate, movement.Animation.State.ActionCount));
    }

    [Fact, Behaviour("demo-world.motions.combat-stance", "spec/01b, 2, rule 1: links of the style; spec/01, 4.8: what it refuses")]
    public void A_human_puts_fists_up_over_a_link_fights_and_lets_them_down()
    {
        (PhysicsBody body, MovementManager movement) = Spawn(DemoIds.HumanSetup);
        Do(movement, MotionCommand.HandCombat);
        Tick(3);
        Assert.Equal((MotionCommand.HandCombat, 8), (movement.Animation!.Style, movement.Animation.CurrentAnimation!.FrameCount));
        Tick(30);
        Assert.Equal(40, movement.Animation.CurrentAnimation!.FrameCount);
        (MotionCommand Motion, MotionError Error)[] refused =
        [
            (MotionCommand.Crouch, MotionError.NoCrouchInCombat), (MotionCommand.Sitting, MotionError.NoSitInCombat),
            (MotionCommand.Sleeping, MotionError.NoSleepInCombat), (MotionCommand.Wave, MotionError.NoEmoteInCombat),
        ];
        foreach ((MotionCommand motion, MotionError error) in refused)
            Assert.Equal(error, movement.DoMotion(motion, new MovementParameters()));

        Assert.Equal(MotionError.None, movement.DoMotion(Attack, new MovementParameters()));
        Tick(60);
        Assert.Equal((0, MotionCommand.Ready), (movement.Animation.State.ActionCount, movement.Animation.Substate));

        // Fists do not slow anybody: walking speed, and turning on the way.
        Do(movement, MotionCommand.WalkForward);
        Tick(30);
        float before = body.Position.Frame.Origin.Y;
        Tick(60);
        Assert.Equal(2 * 3.12f, body.Position.Frame.Origin.Y - before, 0.21f);
        Assert.Equal(MotionError.None, movement.DoMotion(MotionCommand.TurnRight, new MovementParameters()));
        Assert.Equal(new Vector3(0, 0, -1.5f), movement.Animation.Sequence.Omega);

        Assert.Equal(MotionError.None, movement.StopMotion(MotionCommand.TurnRight, new MovementParameters()));
        Do(movement, MotionCommand.NonCombat);
        Tick(30);
        Assert.Equal((MotionCommand.NonCombat, MotionCommand.Ready), (movement.Animation.Style, movement.Animation.Substate));
    }

    [Fact, Behaviour("demo-world.motions.attack-is-for-combat", "spec/01b, 2, rule 3: no link, no action")]
    public void In_peace_the_blow_has_no_animation()
    {
        (_, MovementManager movement) = Spawn(DemoIds.HumanSetup);
        Assert.Equal(MotionError.NoMotionData, movement.DoMotion(Attack, new MovementParameters()));
        Tick(5);
        Assert.Equal(0, movement.Animation!.State.ActionCount);
    }

    [Theory, Behaviour("demo-world.creatures.speeds", "spec/01b, 4: a cycle moves its velocity times its speed")]
    [InlineData(DemoIds.SmallCreatureSetup, MotionCommand.WalkForward, 1.5f)]
    [InlineData(DemoIds.SmallCreatureSetup, MotionCommand.RunForward, 3f)]
    [InlineData(DemoIds.LargeCreatureSetup, MotionCommand.WalkForward, 0.9f)]
    [InlineData(DemoIds.LargeCreatureSetup, MotionCommand.RunForward, 1.8f)]
    public void A_creature_moves_at_the_speed_of_its_own_table(uint setup, MotionCommand motion, float speed)
    {
        (PhysicsBody body, MovementManager movement) = Spawn(setup);
        Do(movement, motion);
        Tick(30);
        float before = body.Position.Frame.Origin.Y;
        Tick(120);
        Assert.Equal(4 * speed, body.Position.Frame.Origin.Y - before, 2 * speed / 30);
        Assert.True(body.OnWalkable);
    }

    [Theory, Behaviour("demo-world.creatures.die-and-bite", "spec/01b, 2, rules 2 and 3; spec/01, 4.7: Dead drops links")]
    [InlineData(DemoIds.SmallCreatureSetup)]
    [InlineData(DemoIds.LargeCreatureSetup)]
    public void A_creature_strikes_and_dies_over_its_own_animations(uint setup)
    {
        (_, MovementManager movement) = Spawn(setup);
        Assert.Equal(MotionError.None, movement.DoMotion(Attack, new MovementParameters()));
        Tick(90);
        Assert.Equal((MotionCommand.Ready, 0), (movement.Animation!.Substate, movement.Animation.State.ActionCount));
        Do(movement, MotionCommand.Dead);
        Tick(3);
        Assert.True(movement.Animation.CurrentAnimation!.FrameCount > 10);
        Tick(90);
        Assert.Equal((MotionCommand.Dead, 1), (movement.Animation.Substate, movement.Animation.CurrentAnimation!.FrameCount));
    }

    private static void Do(MovementManager movement, MotionCommand motion) =>
        Assert.Equal(MotionError.None, movement.DoMotion(motion, new MovementParameters()));

    private (PhysicsBody Body, MovementManager Movement) Spawn(uint setupId, IWeenieObj? weenie = null)
    {
        Assert.True(DemoPlaces.TryFind("meadow", out NamedPlace meadow));
        Position place = new(meadow.CellId, meadow.Origin);
        engine.World.EnsureLoadedAround(place, 1);
        SetupAsset setup = files.Cache.GetSetup(setupId);
        PhysicsBody body = engine.CreateBody(
            1, setup, weenie: WeenieTraits.Present | WeenieTraits.Creature,
            motions: new BodyMotions(MotionTableLoader.LoadFor(files.Cache.Source, setup), weenie ?? new OtherWeenie()));
        Assert.True(body.EnterWorld(place));
        Tick(10);
        Assert.True(body.OnWalkable);
        return (body, engine.MovementOf(body)!);
    }

    private void Tick(int count)
    {
        for (int i = 0; i < count; i++) engine.Tick(++frames * FrameTime);
    }
}
