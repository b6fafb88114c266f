using Surefoot.Client;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.World;

namespace Surefoot.Server.Tests.Authority;

/// <summary>Verdicts on ways that lead through doors and other players.</summary>
public sealed class MovementAuthorityObstacleTests(DemoGround ground) : IClassFixture<DemoGround>
{
    private const string Meadow = "runway", Door = "door";
    private const WeenieTraits Player = WeenieTraits.Present | WeenieTraits.Creature | WeenieTraits.Player;

    /// <summary>Whoever stood still for so long is where the client saw it, seconds.</summary>
    private const double Long = 30;

    [Fact, Behaviour("authority.door.closed", "design, server operator: what is in the way; spec/06: a door that is not ethereal stops")]
    public void Who_walks_through_a_door_that_was_shut_for_long_is_refused()
    {
        AuthorityFixture f = new(ground, Door);
        ground.SpawnDoor(f.Server, 7);
        f.Server.Tick(Long);
        f.Hold(MovementKeys.Forward, 3);
        Assert.Equal(ClaimReason.ThroughWall, f.Objections.First().Reason);
    }

    [Fact, Behaviour("authority.door.open", "spec/06: an ethereal object stops nobody")]
    public void Who_walks_through_an_open_door_is_accepted()
    {
        AuthorityFixture f = new(ground, Door);
        ground.SpawnDoor(f.Server, 7).SetEthereal(true);
        f.Server.Tick(Long);
        f.Hold(MovementKeys.Forward, 3);
        Assert.Empty(f.Objections);
    }

    [Fact, Behaviour("authority.door.closes", "design, server operator: messages are under way while a door shuts")]
    public void A_door_that_shut_a_moment_ago_may_have_been_open_when_the_player_went_through()
    {
        AuthorityFixture f = new(ground, Door);
        PhysicsBody door = ground.SpawnDoor(f.Server, 7);
        door.SetEthereal(true);
        f.Server.Tick(Long);
        door.SetEthereal(false);
        f.Server.Tick(Long + 1);
        f.Hold(MovementKeys.Forward, 3);
        Assert.Empty(f.Objections);
    }

    [Fact, Behaviour("authority.door.opens", "design, server operator: messages are under way while a door opens")]
    public void Who_still_stands_before_a_door_that_the_server_has_opened_is_accepted()
    {
        AuthorityFixture f = new(ground, Door);
        PhysicsBody door = ground.SpawnDoor(f.Server, 7);
        ground.SpawnDoor(f.World, 7);
        f.Server.Tick(Long);
        door.SetEthereal(true);
        f.Server.Tick(Long + 1);
        f.Hold(MovementKeys.Forward, 4);
        Assert.Empty(f.Objections);
        Assert.True(f.Verdicts.Count > 3);
    }

    [Theory, Behaviour("authority.players", "spec/06: who stops whom")]
    [InlineData(WeenieTraits.None, WeenieTraits.None, false)]
    [InlineData(WeenieTraits.PK, WeenieTraits.None, false)]
    [InlineData(WeenieTraits.PK, WeenieTraits.PK, true)]
    [InlineData(WeenieTraits.PKLite, WeenieTraits.PKLite, true)]
    [InlineData(WeenieTraits.PK, WeenieTraits.PKLite, false)]
    [InlineData(WeenieTraits.Impenetrable, WeenieTraits.None, true)]
    [InlineData(WeenieTraits.None, WeenieTraits.Impenetrable, true)]
    public void Players_pass_each_other_but_killers_of_a_kind_and_the_impenetrable(WeenieTraits own, WeenieTraits other, bool stops)
    {
        AuthorityFixture f = new(ground, Meadow);
        ground.Spawn(f.Server, 7, DemoGround.At(Meadow, ahead: 6)).SetWeenie(Player | other);
        f.Server.Tick(Long);
        f.Authority.Traits = own;
        f.Hold(MovementKeys.Forward, 1);
        f.Say(f.Here);
        Assert.Equal(stops, f.Objections.Any());
        if (stops) Assert.Equal(ClaimReason.ThroughWall, f.Objections.First().Reason);
    }

    [Theory, Behaviour("authority.own-body", "spec/02, 4.21: nobody runs into himself")]
    [InlineData(true)]
    [InlineData(false)]
    public void The_players_own_body_in_the_servers_world_is_not_in_its_way(bool isOwn)
    {
        AuthorityFixture f = new(ground, Meadow);
        PhysicsBody body = ground.Spawn(f.Server, 7, DemoGround.At(Meadow, ahead: 6));
        body.SetWeenie(Player | WeenieTraits.PK);
        f.Server.Tick(Long);
        f.Authority.Traits = WeenieTraits.PK;
        if (isOwn) f.Authority.Body = body;
        f.Hold(MovementKeys.Forward, 1);
        f.Say(f.Here);
        Assert.Equal(!isOwn, f.Objections.Any());
    }
}
