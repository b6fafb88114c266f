using System.Numerics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Decisions;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Transitions;
using Surefoot.Physics.Transitions.Obstacles;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Tests.Transitions.Obstacles;

/// <summary>Who stops whom: the table of specification 06, 6, and the rules of 02, 4.21.</summary>
public class TargetRuleTests
{
    private const WeenieTraits Weenie = WeenieTraits.Present;
    private const WeenieTraits Creature = Weenie | WeenieTraits.Creature;
    private const WeenieTraits Player = Creature | WeenieTraits.Player;
    private const WeenieTraits Killer = Player | WeenieTraits.PK;
    private const WeenieTraits Lite = Player | WeenieTraits.PKLite;
    private const WeenieTraits Impenetrable = Player | WeenieTraits.Impenetrable;
    private const PhysicsState Plain = PhysicsState.Default;
    private const PhysicsState Missile = PhysicsState.Default | PhysicsState.Missile;
    private const PhysicsState Ethereal = PhysicsState.Default | PhysicsState.Ethereal;

    private static readonly SetupAsset Ball = StubWorld.Setup(new Sphere(Vector3.Zero, 0.5f));

    /// <summary>What the target did to the mover: stopped it, was touched only, or was not noticed.</summary>
    public enum Outcome
    {
        Stops,
        Touched,
        Passes,
    }

    [Theory, Behaviour("object.target.table", "spec/06, 6; spec/02, 4.21; CPhysicsObj::FindObjCollisions @0x0050F050")]
    [InlineData(Player, Plain, "Passes Passes Passes Passes Stops Passes Touched Stops Stops")]
    [InlineData(Killer, Plain, "Passes Stops Passes Passes Stops Passes Touched Stops Stops")]
    [InlineData(Lite, Plain, "Passes Passes Stops Passes Stops Passes Touched Stops Stops")]
    [InlineData(Killer | WeenieTraits.PKLite, Plain, "Passes Stops Stops Passes Stops Passes Touched Stops Stops")]
    [InlineData(Impenetrable, Plain, "Stops Stops Stops Stops Stops Passes Touched Stops Stops")]
    [InlineData(Creature, Plain, "Stops Stops Stops Stops Stops Passes Touched Stops Stops")]
    [InlineData(WeenieTraits.None, Plain, "Stops Stops Stops Stops Stops Passes Touched Stops Stops")]
    [InlineData(Weenie, Missile, "Stops Stops Stops Stops Stops Passes Touched Stops Stops")]
    [InlineData(Creature, Ethereal, "Touched Touched Touched Touched Touched Passes Touched Stops Touched")]
    public void The_table_of_who_stops_whom(WeenieTraits mover, PhysicsState moverState, string expected)
    {
        // A killer of both kinds as a target tells whether the kinds are compared one by one: a target of neither kind is passed by both.
        (WeenieTraits Weenie, PhysicsState State)[] targets =
        [
            (Player, Plain), (Killer, Plain), (Lite, Plain), (Player, PhysicsState.None), (Creature, Plain), (Weenie, Missile),
            (WeenieTraits.None, Ethereal), (WeenieTraits.None, Plain | PhysicsState.Static), (WeenieTraits.None, Plain),
        ];
        Assert.Equal(
            expected.Split(' ').Select(Enum.Parse<Outcome>),
            targets.Select(t => Meet(mover, moverState, t.Weenie, t.State, MoverFlags.None, out _)));
    }

    [Theory, Behaviour("object.target.impenetrable-player", "spec/02, 4.21, step 4")]
    [InlineData(Player)]
    [InlineData(Killer)]
    [InlineData(Creature)]
    public void An_impenetrable_player_stops_everyone(WeenieTraits mover) =>
        Assert.Equal(Outcome.Stops, Meet(mover, Plain, Impenetrable, Plain, MoverFlags.None, out _));

    [Fact, Behaviour("object.target.missile-and-ethereal", "spec/02, 4.21, step 6")]
    public void A_missile_does_not_notice_an_ethereal_thing_that_the_game_knows_of()
    {
        Assert.Equal(Outcome.Passes, Meet(Weenie, Missile, Weenie, Ethereal, MoverFlags.None, out _));
        Assert.Equal(Outcome.Touched, Meet(Weenie, Missile, WeenieTraits.None, Ethereal, MoverFlags.None, out _));
    }

    [Fact, Behaviour("object.target.ethereal-and-ignored", "spec/02, 4.21, step 1")]
    public void An_ethereal_thing_that_ignores_collisions_is_not_noticed()
    {
        Assert.Equal(Outcome.Passes,
            Meet(Player, Plain, WeenieTraits.None, Ethereal | PhysicsState.IgnoreCollisions, MoverFlags.None, out _));
        Assert.Equal(Outcome.Stops, Meet(Player, Plain, WeenieTraits.None, Plain | PhysicsState.IgnoreCollisions, MoverFlags.None, out _));
    }

    [Fact, Behaviour("object.target.viewer-passes-creatures", "spec/02, 4.21, step 2")]
    public void The_camera_passes_creatures_and_nothing_else()
    {
        Assert.Equal(Outcome.Passes, Meet(Player, Plain, Creature, Plain, MoverFlags.IsViewer, out _));
        Assert.Equal(Outcome.Stops, Meet(Player, Plain, Weenie, Plain, MoverFlags.IsViewer, out _));
    }

    [Fact, Behaviour("object.target.ignore-creatures", "spec/02, 4.21, step 8")]
    public void A_mover_that_ignores_creatures_only_touches_them()
    {
        Assert.Equal(Outcome.Touched, Meet(Weenie, Plain, Creature, Plain, MoverFlags.IgnoreCreatures, out CollisionInfo info));
        Assert.False(info.CollisionNormalValid);
        Assert.Equal(Outcome.Stops, Meet(Weenie, Plain, Weenie, Plain, MoverFlags.IgnoreCreatures, out _));
    }

    [Fact, Behaviour("object.target.static-is-environment", "spec/02, 4.21, step 8")]
    public void A_static_thing_counts_as_environment_for_a_mover_without_contact_and_is_not_listed()
    {
        Meet(Player, Plain, WeenieTraits.None, Plain | PhysicsState.Static, MoverFlags.None, out CollisionInfo info);
        Assert.Equal((true, 0), (info.CollidedWithEnvironment, info.ObjectCount));
        Meet(Player, Plain, WeenieTraits.None, Plain | PhysicsState.Static, MoverFlags.Contact, out info);
        Assert.Equal((false, 0), (info.CollidedWithEnvironment, info.ObjectCount));
        Meet(Player, Plain, WeenieTraits.None, Plain, MoverFlags.None, out info);
        Assert.Equal((false, 1), (info.CollidedWithEnvironment, info.ObjectCount));
    }

    [Fact, Behaviour("object.target.stepping-down", "spec/02, 4.21, steps 3 and 8")]
    public void Stepping_down_ignores_what_is_ethereal_and_lists_nothing()
    {
        Assert.Equal(Outcome.Passes, Meet(Player, Plain, WeenieTraits.None, Ethereal, MoverFlags.None, out _, stepDown: true));
        Assert.Equal(Outcome.Stops, Meet(Player, Plain, WeenieTraits.None, Plain, MoverFlags.None, out CollisionInfo info, stepDown: true));
        Assert.Equal(0, info.ObjectCount);
    }

    private static Outcome Meet(
        WeenieTraits moverWeenie, PhysicsState moverState, WeenieTraits weenie, PhysicsState state, MoverFlags flags,
        out CollisionInfo info, bool stepDown = false)
    {
        Transition transition = new(new StubWorld(_ => null));
        transition.Reset();
        transition.Object.Init(new WorldObject(1, Ball, moverState) { Weenie = moverWeenie }, flags);
        SpherePath path = transition.Path;
        Position place = new(StubWorld.CellId, new Vector3(12, 12, 5));
        path.InitSpheres(Ball.Spheres, 1);
        path.InitPath(null, true, place, place);
        path.SetCheckPos(place, null);
        path.InsertType = InsertType.Placement;
        path.SteppingDown = stepDown;

        WorldObject target = new(2, Ball, state) { Weenie = weenie };
        target.SeatAt(new Position(StubWorld.CellId, new Vector3(12.2f, 12, 5)), null);
        TransitionState answer = target.FindObjCollisions(transition);
        info = transition.Collision;
        Assert.False(path.ObstructionEthereal);
        return answer != TransitionState.OK ? Outcome.Stops : info.ObjectCount > 0 ? Outcome.Touched : Outcome.Passes;
    }
}
