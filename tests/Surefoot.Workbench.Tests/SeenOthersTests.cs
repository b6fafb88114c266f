using Microsoft.Extensions.Logging.Abstractions;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Physics.World;
using Surefoot.Protocol.Session;
using Surefoot.Server;
using Surefoot.Workbench.Simulation;
using Surefoot.Workbench.Wire;

namespace Surefoot.Workbench.Tests;

/// <summary>What a page sees of others: moved by a server's messages, over a network as bad as it likes.</summary>
public sealed class SeenOthersTests : IDisposable
{
    private static readonly NetworkQuality Bad = new(delay: 0.2, jitter: 0.1, loss: 0.05);

    private readonly SimulatedWorld world = new(
        "Demo", DatSet.Open(DemoWorldCache.GetOrCreate()), KnownPlaces.Demo(), NullLogger.Instance, DemoSpawns.All);

    private double now = 100;

    public void Dispose() => world.Dispose();

    [Fact]
    [Behaviour("workbench.others.seen-by-messages", "spec/09, 5")]
    public void Another_player_is_seen_where_messages_put_it_and_comes_to_where_it_is_in_truth()
    {
        (IWorkbenchPlayer looks, IWorkbenchPlayer runs) = Two("The runway");
        looks.UseNetwork(Bad, showsTruth: true);
        Pass(2);
        runs.SetKeys(PlayerKeys.Forward, now);
        Pass(0.05);
        Assert.True(Seen(looks).Speed < 0.01, "no message has come yet");
        double farthest = 0;
        for (int i = 0; i < 60; i++)
        {
            Pass(0.05);
            farthest = Math.Max(farthest, Apart(Seen(looks), runs.Pose));
        }

        Assert.True(Seen(looks).Speed > 5, "it is seen running");
        // A run of 10.6 m/s that is told 0.1 to 0.3 s late, and positions of a second ago that are then followed.
        Assert.InRange(farthest, 10.6 * 0.1, 10.6);
        runs.SetKeys(PlayerKeys.None, now);
        Pass(6);
        Assert.True(Seen(looks).Speed < 0.01, "it is seen standing");
        // spec/09, 3.2: within 5 cm of what was told, retail is content.
        Assert.InRange(Apart(Seen(looks), runs.Pose), 0, 0.05);
        Assert.InRange(Apart(Truth(looks)[2], runs.Pose), 0, 0);
    }

    [Fact]
    [Behaviour("workbench.others.jump-and-teleport-are-seen", "spec/09, 4.4 and 5.3")]
    public void A_jump_is_seen_in_the_air_and_a_player_put_elsewhere_is_not_drawn_on_the_way()
    {
        (IWorkbenchPlayer looks, IWorkbenchPlayer acts) = Two("Meadow");
        Pass(1);
        acts.SetKeys(PlayerKeys.Jump, now);
        Pass(1);
        acts.SetKeys(PlayerKeys.None, now);
        bool wasUp = false;
        for (int i = 0; i < 40; i++)
        {
            Pass(0.05);
            wasUp |= (Seen(looks).Flags & PoseFlags.Contact) == 0 && Seen(looks).Position.Z > acts.Pose.Position.Z - 1;
        }

        Assert.True(wasUp, "it is seen in the air");
        Assert.InRange(Apart(Seen(looks), acts.Pose), 0, 0.05);
        byte before = Seen(looks).Teleports;
        acts.Goto(world.Places.First(place => place.CellId == 0xA9B40028), now);
        Pass(1);
        Assert.InRange(Apart(Seen(looks), acts.Pose), 0, 0.05);
        Assert.NotEqual(before, Seen(looks).Teleports);
    }

    [Fact]
    [Behaviour("workbench.others.far-are-forgotten", "spec/09, 5.6")]
    public void Who_goes_away_is_forgotten_and_is_known_again_when_it_comes_back()
    {
        (IWorkbenchPlayer looks, IWorkbenchPlayer goes) = Two("Meadow");
        Pass(1);
        WorkbenchPlace home = world.Places[0];
        goes.Goto(Place("The dungeon"), now);
        Pass(1);
        Assert.Empty(Others(looks));
        goes.Goto(home, now);
        Pass(1);
        Assert.InRange(Apart(Seen(looks), goes.Pose), 0, 0.05);
        world.Leave(goes);
        Pass(0.2);
        Assert.Empty(Others(looks));
    }

    [Fact]
    [Behaviour("workbench.creatures.follow-flee-stand", "design.md, Who uses it")]
    public void A_creature_follows_flees_and_stands_as_it_is_asked()
    {
        IWorkbenchPlayer player = world.Join(1, PlayerSettings.Default, Place("Creatures at pasture"), now);
        player.UseNetwork(default, showsTruth: true);
        Pass(1);
        BodyPose creature = Near(player).Where(one => one.Kind == BodyKind.Wanderer).MinBy(one => Apart(one, player.Pose));
        player.Ask(creature.Id, CreatureWish.Follow);
        Pass(12);
        // Within its reach of 0.6 m and 1 m of slack, from surface to surface: bodies of 0.5 m and the creature's own.
        Assert.InRange(Apart(Find(player, creature.Id), player.Pose), 0, 1.6 + 0.5 + Math.Max(creature.Size.X, creature.Size.Y));
        player.SetKeys(PlayerKeys.Back, now);
        Pass(4);
        player.SetKeys(PlayerKeys.None, now);
        Pass(12);
        Assert.InRange(Apart(Find(player, creature.Id), player.Pose), 0, 1.6 + 0.5 + Math.Max(creature.Size.X, creature.Size.Y));

        player.Ask(creature.Id, CreatureWish.Flee);
        Pass(10);
        Assert.True(Apart(Find(player, creature.Id), player.Pose) > 10, "it fled");
        player.Ask(creature.Id, CreatureWish.Stand);
        Pass(2);
        BodyPose stands = Find(player, creature.Id);
        Pass(15);
        Assert.InRange(Apart(Find(player, creature.Id), stands), 0, 0.01);
        Assert.InRange(Apart(Truth(player)[creature.Id], Find(player, creature.Id)), 0, 0.05);

        player.Ask(creature.Id, CreatureWish.AsItLikes);
        Pass(25);
        Assert.True(Apart(Find(player, creature.Id), stands) > 0.5, "it goes its own ways again");
        player.Ask(12345, CreatureWish.Follow);
        player.Ask(1, CreatureWish.Flee);
    }

    [Fact]
    [Behaviour("workbench.creatures.seen-late", "spec/09, 5")]
    public void A_page_behind_a_slow_network_sees_creatures_where_they_were()
    {
        IWorkbenchPlayer near = world.Join(1, PlayerSettings.Default, Place("Creatures at pasture"), now);
        IWorkbenchPlayer far = world.Join(2, PlayerSettings.Default, Place("Creatures at pasture"), now);
        far.UseNetwork(new NetworkQuality(delay: 1), showsTruth: true);
        Pass(3);
        double atOnce = 0, late = 0;
        near.UseNetwork(default, showsTruth: true);
        for (int i = 0; i < 200; i++)
        {
            Pass(0.1);
            foreach (BodyPose one in Near(near).Where(one => one.Kind == BodyKind.Wanderer))
            {
                atOnce = Math.Max(atOnce, Apart(one, Truth(near)[one.Id]));
                late = Math.Max(late, Apart(Find(far, one.Id), Truth(far)[one.Id]));
            }
        }

        // A walk of 3 m/s at most is seen a second late; without delay, what a driver orders it is seen doing in the next quantum.
        Assert.True(late > 1, $"{late:F2} m behind");
        Assert.True(atOnce < late / 2, $"{atOnce:F2} m off without delay, {late:F2} m with");
    }

    private (IWorkbenchPlayer One, IWorkbenchPlayer Two) Two(string place)
    {
        WorkbenchPlace where = place == "Meadow" ? world.Places[0] : Place(place);
        IWorkbenchPlayer one = world.Join(1, PlayerSettings.Default, where, now);
        return (one, world.Join(2, PlayerSettings.Default, where, now));
    }

    private WorkbenchPlace Place(string name) => world.Places.Single(place => place.Name == name);

    private void Pass(double seconds)
    {
        for (double end = now + seconds; now < end;) world.Advance(now += WorldTime.Quantum);
    }

    private List<(uint Id, PlayerPose Pose)> Others(IWorkbenchPlayer player)
    {
        List<(uint Id, PlayerPose Pose)> others = [];
        world.LookAtPlayers(player, others);
        return others;
    }

    private PlayerPose Seen(IWorkbenchPlayer player) => Assert.Single(Others(player)).Pose;

    private List<BodyPose> Near(IWorkbenchPlayer player)
    {
        List<BodyPose> near = [];
        world.Look(player, near);
        return near;
    }

    private BodyPose Find(IWorkbenchPlayer player, uint id) => Near(player).Single(one => one.Id == id);

    private Dictionary<uint, Position> Truth(IWorkbenchPlayer player)
    {
        List<TruePlace> truth = [];
        world.LookAtTruth(player, truth);
        return truth.ToDictionary(one => one.Id, one => new Position(one.CellId, one.Position));
    }

    private static double Apart(in BodyPose one, in PlayerPose other) => Apart(Of(one), Of(other));

    private static double Apart(in BodyPose one, in BodyPose other) => Apart(Of(one), Of(other));

    private static double Apart(in BodyPose one, in Position other) => Apart(Of(one), other);

    private static double Apart(in PlayerPose one, in PlayerPose other) => Apart(Of(one), Of(other));

    private static double Apart(in Position one, in PlayerPose other) => Apart(one, Of(other));

    private static double Apart(in Position one, in BodyPose other) => Apart(one, Of(other));

    private static double Apart(in Position one, in Position other) => one.OffsetTo(other).Length();

    private static Position Of(in BodyPose one) => new(one.CellId, one.Position);

    private static Position Of(in PlayerPose one) => new(one.CellId, one.Position);
}
