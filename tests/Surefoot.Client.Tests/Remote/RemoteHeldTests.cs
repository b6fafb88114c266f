using System.Numerics;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.Tests.Transitions;
using Surefoot.Protocol.Messages;
using static Surefoot.Client.Tests.RemoteFixture;

namespace Surefoot.Client.Tests;

/// <summary>Held and picked up objects of a server: specification 09, 5.6, 5.8 and 5.11.</summary>
public class RemoteHeldTests
{
    private const uint Sword = 0x90000001;

    /// <summary>Where the hand of somebody at the start is.</summary>
    private static readonly Vector3 InHand = Start + new Vector3(0.5f, 0.25f, 1);

    private readonly RemoteFixture f = new();

    private PhysicsBody SwordBody => f.Remote.Find(Sword)!.Body;

    private Vector3 SwordAt => SwordBody.Position.Frame.Origin;

    [Fact]
    [Behaviour("remote.parent.stamps", "spec/09, 5.1, 5.2 and 5.6; HandleParentEvent @0x004535D0, DoParentEvent @0x00452290")]
    public void A_parent_event_puts_an_object_into_a_hand_by_the_position_stamp_of_the_object()
    {
        f.CreateStanding(Stamps(instance: 3));
        f.Create(DescribeThing(Sword, Start + new Vector3(2, 0, 0)));
        f.Say(new ParentEvent(One, Sword, Hand, 0, 2, 1));
        Assert.Equal((null, 1L), (SwordBody.Parent, f.Remote.Drops[RemoteDrop.EarlierLife]));
        f.Say(new ParentEvent(One, Sword, Hand, 0, 3, 0));
        Assert.Equal((null, 1L), (SwordBody.Parent, f.Remote.Drops[RemoteDrop.Late]));
        f.Say(new ParentEvent(One, Sword, Hand, 0, 3, 1));
        Assert.Same(f.Body, SwordBody.Parent);
        AssertNear(InHand);
        f.Say(MotionOf(1, 1, Run(), instance: 3));
        f.Frames(30);
        Assert.True(f.Origin.Y > Start.Y + 3);
        AssertNear(f.Origin + (InHand - Start));
    }

    [Fact]
    [Behaviour("remote.parent.unknown", "spec/08, 4.3: ParentEvent; spec/09, 5.9, last line")]
    public void A_parent_event_waits_for_the_holder_then_for_the_object()
    {
        f.Say(new ParentEvent(One, Sword, Hand, 0, 1, 1));
        Assert.Equal(1, f.Remote.AwaitedCount);
        f.Create(Describe(One, Start));
        Assert.Equal((1, 1), (f.Remote.AwaitedCount, f.Remote.WaitingMessageCount));
        f.Create(DescribeThing(Sword));
        Assert.Same(f.Body, SwordBody.Parent);
        Assert.Equal(0, f.Remote.AwaitedCount);

        // One that is late for its holder waits for an unknown object all the same.
        f.Say(new ParentEvent(One, Other, Hand, 0, 0, 1));
        Assert.Equal(1, f.Remote.AwaitedCount);
        f.Create(DescribeThing(Other));
        Assert.Equal((null, 1L), (f.Remote.Find(Other)!.Body.Parent, f.Remote.Drops[RemoteDrop.EarlierLife]));
    }

    [Fact]
    [Behaviour("remote.parent.player", "spec/09, 5.1 and 5.11")]
    public void The_local_player_holds_things_too()
    {
        f.Say(new CreateObject(Describe(PlayerId, Start, Stamps(instance: 8))));
        f.Create(DescribeThing(Sword, Start));
        f.Say(new ParentEvent(PlayerId, Sword, Hand, 0, 7, 1));
        Assert.Null(SwordBody.Parent);
        f.Say(new ParentEvent(PlayerId, Sword, Hand, 0, 8, 1));
        Assert.Same(f.Engine.Player, SwordBody.Parent);
    }

    [Fact]
    [Behaviour("remote.parent.the-player", "design, bad input: counted by reason")]
    public void Nobody_takes_the_player_into_its_hand()
    {
        RemoteFixture f = new();
        f.CreateStanding();
        f.Say(new ParentEvent(One, PlayerId, Hand, 0, 1, 1));
        Assert.Equal((1L, 1L), (f.Remote.Drops[RemoteDrop.NotOurs], f.Remote.Drops.Total));
        Assert.Null(f.Engine.Find(PlayerId)!.Parent);
    }

    [Fact]
    [Behaviour("remote.parent.refused", "spec/09, 5.11; design, decision 7")]
    public void A_location_that_there_is_not_and_a_ring_are_counted_and_change_nothing()
    {
        f.CreateStanding();
        f.Create(Describe(Other, Start + new Vector3(3, 0, 0)));
        f.Say(new ParentEvent(One, Other, NoSuchLocation, 0, 1, 1));
        f.Say(new ParentEvent(One, One, Hand, 0, 1, 1));
        f.Say(new ParentEvent(One, Other, Hand, 0, 1, 2));
        Vector3 place = f.Origin;
        f.Say(new ParentEvent(Other, One, Hand, 0, 1, 2));
        Assert.Equal((null, place, 3L), (f.Body.Parent, f.Origin, f.Remote.Drops[RemoteDrop.NotHeld]));
        Assert.Same(f.Body, f.Remote.Find(Other)!.Body.Parent);
    }

    [Fact]
    [Behaviour("remote.drop.without-contact", "spec/09, 5.11, consequences")]
    public void A_held_object_that_is_told_a_place_in_the_air_stays_where_the_hand_was_and_falls()
    {
        HoldSword();
        f.Say(PositionOf(Start + new Vector3(5, 5, 0), 2, contact: false, guid: Sword));
        Assert.Null(SwordBody.Parent);
        AssertNear(InHand);
        f.Frames(60);
        Assert.Equal((InHand.X, InHand.Y, 0f), (SwordAt.X, SwordAt.Y, MathF.Round(SwordAt.Z, 2)));
    }

    [Fact]
    [Behaviour("remote.drop.with-contact", "spec/09, 5.11, consequences")]
    public void One_that_had_ticks_before_follows_a_place_on_the_ground_only_once_it_has_landed()
    {
        HoldSword();
        f.Say(PositionOf(Start + new Vector3(2, 0, 0), 2, guid: Sword));
        Assert.True(SwordBody.IsInterpolating);
        AssertNear(InHand);
        f.Frames(5);
        Assert.Equal(InHand.X, SwordAt.X);
        f.Frames(60);
        Assert.Equal(Start.X + 2, SwordAt.X, 0.06f);
    }

    [Fact]
    [Behaviour("remote.drop.newer-teleport", "spec/09, 5.11, consequences: a server that drops cleanly")]
    public void One_with_a_newer_teleport_is_put_there()
    {
        HoldSword();
        f.Say(PositionOf(Start + new Vector3(2, 0, 0), 2, teleport: 1, guid: Sword));
        AssertNear(Start + new Vector3(2, 0, 0));
        Assert.Null(SwordBody.Parent);
    }

    [Fact]
    [Behaviour("remote.pickup", "spec/09, 5.2, 5.6 and 5.10")]
    public void A_picked_up_object_is_in_no_cell_stays_known_and_comes_back_where_it_is_told()
    {
        HoldSword();
        f.Say(new PickupEvent(Sword, 1, 1));
        Assert.NotNull(SwordBody.Parent);
        f.Say(new PickupEvent(Sword, 1, 2));
        Assert.Equal((null, null, 0u, 0), (SwordBody.Parent, SwordBody.Cell, SwordBody.Position.CellId, f.Body.HeldCount));
        f.FramesUntil(60);
        f.Say(PositionOf(Start + new Vector3(2, 0, 0), 3, contact: false, guid: Sword));
        AssertNear(Start + new Vector3(2, 0, 0));
    }

    [Fact]
    [Behaviour("remote.create.children", "spec/09, 5.8, step 5; SetChildren @0x00509370")]
    public void What_a_creature_holds_is_taken_from_wherever_it_is_when_the_creature_comes()
    {
        f.Create(DescribeThing(Sword, Start + new Vector3(7, 0, 0)));
        f.Create(Holding((Sword, Hand)));
        Assert.Same(f.Body, SwordBody.Parent);
        AssertNear(InHand);
    }

    [Fact]
    [Behaviour("remote.create.unknown-children", "spec/09, 5.11, consequences; 5.8, step 7")]
    public void An_unknown_object_that_a_creature_holds_is_waited_for_without_end_and_comes_into_its_hand()
    {
        f.Create(Holding((Sword, Hand), (Other, NoSuchLocation)));
        Assert.Equal((2, 1L), (f.Remote.AwaitedCount, f.Remote.Drops[RemoteDrop.NotHeld]));
        f.FramesUntil(60);
        Assert.Equal(1, f.Remote.AwaitedCount);
        Assert.Equal(2, f.Told.Count(told => told == $"missing {Sword:X}"));
        // Its own description names a place, but no holder.
        f.Create(DescribeThing(Sword, Start + new Vector3(7, 0, 0)));
        Assert.Same(f.Body, SwordBody.Parent);
        AssertNear(InHand);
    }

    [Fact]
    [Behaviour("remote.create.unknown-children-end-with-the-holder", "spec/09, 5.11; design, decision 7: bounded")]
    public void A_promised_object_is_given_up_25_seconds_after_its_holder_is_gone()
    {
        f.Create(Holding((Sword, Hand)));
        f.FramesUntil(40);
        f.Say(new DeleteObject(One, 1));
        f.FramesUntil(64.9);
        Assert.Equal(1, f.Remote.AwaitedCount);
        f.FramesUntil(65.2);
        Assert.Equal(0, f.Remote.AwaitedCount);
    }

    [Fact]
    [Behaviour("remote.create.unknown-parent", "spec/08, 4.5, step 1; spec/09, 5.8")]
    public void An_object_in_an_unknown_hand_waits_for_the_hand()
    {
        ObjectDescription sword = DescribeThing(Sword);
        f.Say(new CreateObject(sword with { Physics = sword.Physics with { Parent = new HoldingLink(One, Hand) } }));
        Assert.Equal((null, 1), (f.Remote.Find(Sword), f.Remote.AwaitedCount));
        f.Create(Describe(One, Start));
        Assert.Same(f.Body, SwordBody.Parent);
        AssertNear(InHand);
    }

    [Fact]
    [Behaviour("remote.delete.lets-go", "spec/09, 5.6 and 5.10 c")]
    public void What_a_deleted_creature_held_stays_known_in_no_cell_without_a_timer()
    {
        HoldSword();
        f.Say(new DeleteObject(One, 1));
        Assert.Equal((null, null, StubWorld.CellId), (SwordBody.Parent, SwordBody.Cell, SwordBody.Position.CellId));
        f.FramesUntil(60);
        f.Say(PositionOf(Start + new Vector3(2, 0, 0), 2, guid: Sword));
        AssertNear(Start + new Vector3(2, 0, 0));
    }

    [Fact]
    [Behaviour("remote.create.long-chains", "design, decision 7")]
    public void Ten_thousand_objects_that_wait_for_each_other_are_made_without_end_of_the_stack()
    {
        const uint count = 10_000;
        RemoteFixture many = new(new RemoteWorldOptions { Player = PlayerId, MostAwaited = 20_000 });
        for (uint i = 1; i < count; i++)
        {
            ObjectDescription link = Describe(One + i);
            many.Say(new CreateObject(link with { Physics = link.Physics with { Parent = new HoldingLink(One + i - 1, Hand) } }));
        }

        Assert.Equal((0, (int)count - 1), (many.Remote.Objects.Count, many.Remote.AwaitedCount));
        many.Say(new CreateObject(Describe(One, Start)));
        Assert.Equal(((int)count, 0), (many.Remote.Objects.Count, many.Remote.AwaitedCount));
        Assert.True(many.Remote.Drops[RemoteDrop.NotHeld] > 0);
        many.Frames(2);
    }

    private static ObjectDescription Holding(params ReadOnlySpan<(uint Guid, uint Location)> things)
    {
        ObjectDescription creature = Describe(One, Start);
        HoldingLink[] links = new HoldingLink[things.Length];
        for (int i = 0; i < links.Length; i++) links[i] = new HoldingLink(things[i].Guid, things[i].Location);
        return creature with { Physics = creature.Physics with { Children = [.. links] } };
    }

    private void HoldSword()
    {
        f.CreateStanding();
        f.Create(DescribeThing(Sword, Start + new Vector3(2, 0, 0)));
        f.Frames(5);
        f.Say(new ParentEvent(One, Sword, Hand, 0, 1, 1));
        AssertNear(InHand);
    }

    private void AssertNear(Vector3 expected) =>
        Assert.True(Vector3.Distance(expected, SwordAt) < 1e-3f, $"expected {expected}, is at {SwordAt}");
}
