using System.Numerics;
using Surefoot.DemoWorld;
using Surefoot.Physics;
using Surefoot.Physics.Assets;
using Surefoot.Physics.Bodies;
using Surefoot.Physics.World;
using Surefoot.Server;

namespace Surefoot.Client.Tests;

/// <summary>The butts of the demo world, where a server's arrows and bolts fly.</summary>
public sealed class ArcheryTests : IClassFixture<DemoFiles>
{
    private const double FrameTime = (1.0 / 30) + 1e-9;
    private const WeenieTraits Creature = WeenieTraits.Present | WeenieTraits.Creature;

    private readonly DemoFiles files;
    private readonly PhysicsEngine engine;
    private readonly Missiles missiles;
    private readonly SetupAsset arrow;
    private int frames;

    public ArcheryTests(DemoFiles files)
    {
        this.files = files;
        engine = files.CreateEngine();
        missiles = new Missiles(engine, new MissileOptions { MostFlying = 3, Lifetime = 2 });
        arrow = files.Cache.GetSetup(DemoIds.ArrowSetup);
        engine.World.EnsureLoadedAround(MuzzleOf(Shooter("bow")), 1);
    }

    [Fact, Behaviour("server.missiles.bad-options", "design, decision 7")]
    public void Missiles_that_may_not_fly_or_fly_for_no_time_are_refused()
    {
        foreach (double lifetime in (double[])[0, -1, double.NaN, double.PositiveInfinity])
            Assert.Throws<ArgumentException>(() => new Missiles(engine, new MissileOptions { Lifetime = lifetime }));
        Assert.Throws<ArgumentException>(() => new Missiles(engine, new MissileOptions { MostFlying = 0 }));
    }

    [Fact, Behaviour("demo-world.archery.hits-the-target", "spec/02, 4.6: gravity; spec/06, 7")]
    public void The_archer_s_arrow_hits_the_target_after_its_arc_and_is_taken_away()
    {
        MissileHit hit = Assert.Single(Fire(Shooter("bow"), out PhysicsBody missile, seconds: 1.5));
        Assert.Equal((missile.Id, 0u, 0, -Vector3.UnitY), (hit.MissileId, hit.ObjectId, hit.Quadrant, hit.Impact.Normal));
        // 24 m at 30 m/s · cos 7.57° are 0.807 s; at its height again it would hit the bow's own, 1.4 m over the ground.
        Assert.Equal(0.8, hit.Time, 0.05);
        Assert.Equal(Shooter("bow").Origin.Z, hit.Impact.Place.Frame.Origin.Z, 0.1f);
        Assert.Equal((0, null), (missiles.FlyingCount, engine.Find(missile.Id)));
    }

    [Fact, Behaviour("demo-world.archery.wall-shelters", "spec/03, 4.6: no hit through a wall at 50 m/s")]
    public void The_bolts_of_the_trap_never_reach_the_guard_behind_the_wall()
    {
        PhysicsBody guard = Spawn("guard-sheltered", 7);
        for (int shot = 0; shot < 20; shot++)
        {
            MissileHit hit = Assert.Single(Fire(Shooter("spell-trap"), out _, seconds: 0.7));
            Assert.Equal(0u, hit.ObjectId);
        }

        Assert.Equal(Vector3.Zero, guard.Velocity);
    }

    [Fact, Behaviour("missiles.who-is-hit", "spec/02, 4.15: quadrant; spec/06, 6")]
    public void Who_stands_in_the_way_is_hit_once_and_where()
    {
        DemoShooter bow = Shooter("bow");
        Position way = MuzzleOf(bow);
        way.Frame.Origin += new Vector3(0, 3, -1.395f);
        PhysicsBody visitor = engine.CreateBody(7, files.Cache.GetSetup(DemoIds.HumanSetup), weenie: Creature);
        Assert.True(visitor.EnterWorld(way));
        MissileHit hit = Assert.Single(Fire(bow, out PhysicsBody missile, seconds: 1));
        Assert.Equal((missile.Id, 7u), (hit.MissileId, hit.ObjectId));
        // From behind (64), at two thirds of the height and more (1); right or left is a matter of nothing in the middle.
        Assert.Equal(64 | 1, hit.Quadrant & ~(8 | 16));
    }

    [Fact, Behaviour("missiles.bounds", "design, decision 7")]
    public void There_are_not_more_missiles_than_allowed_and_none_flies_for_ever()
    {
        DemoShooter bow = Shooter("bow");
        Position sky = MuzzleOf(bow);
        sky.Frame.Origin.Z += 200;
        for (int i = 0; i < 3; i++) Assert.NotNull(missiles.Launch(arrow, sky, new Vector3(0, 5 + i, 0), falls: false));
        Assert.Null(missiles.Launch(arrow, sky, Vector3.UnitY, falls: false));
        Run(1.9);
        Assert.Equal((3, 3), (missiles.FlyingCount, missiles.Flying.Count()));
        Run(0.2);
        Assert.Equal(0, missiles.FlyingCount);
        Assert.False(missiles.TryTakeHit(out _));
        Assert.Empty(engine.Bodies);
    }

    [Fact, Behaviour("missiles.bad-input-changes-nothing", "design, decision 7")]
    public void What_cannot_fly_is_refused_and_leaves_nothing_behind()
    {
        Position muzzle = MuzzleOf(Shooter("bow"));
        Assert.Throws<ArgumentException>(() => missiles.Launch(arrow, muzzle, new Vector3(float.NaN, 0, 0), falls: true));
        Assert.Throws<ArgumentException>(() => missiles.Launch(arrow, muzzle, Vector3.UnitY, falls: true, new Vector3(float.NaN)));
        Assert.Throws<ArgumentException>(() => missiles.Launch(arrow, new Position(0, Vector3.One), Vector3.UnitY, falls: true));
        Assert.Throws<ArgumentException>(
            () => missiles.Launch(files.Cache.GetSetup(DemoIds.DoorSetup), muzzle, Vector3.UnitY, falls: true));
        Assert.Null(missiles.Launch(arrow, new Position(0x01010001, Vector3.One), Vector3.UnitY, falls: true));
        Assert.Equal((0, 0), (missiles.FlyingCount, engine.Bodies.Count()));
    }

    [Fact, Behaviour("missiles.spin-or-follow-their-way", "spec/02, 4.4, step 7, and 4.6, step 8")]
    public void An_arrow_looks_along_its_way_and_what_spins_does_not()
    {
        Position sky = MuzzleOf(Shooter("bow"));
        sky.Frame.Origin.Z += 100;
        PhysicsBody straight = missiles.Launch(arrow, sky, new Vector3(20, 0, 0), falls: false)!;
        sky.Frame.Origin.Z += 10;
        PhysicsBody spinning = missiles.Launch(arrow, sky, new Vector3(20, 0, 0), falls: false, new Vector3(0, 0, MathF.PI))!;
        Run(1.01);
        Assert.True(Vector3.Distance(Vector3.UnitX, straight.Position.Frame.YAxis) < 0.01f);
        Assert.True(Vector3.Distance(-Vector3.UnitY, spinning.Position.Frame.YAxis) < 0.02f);
    }

    private static DemoShooter Shooter(string name) => DemoShooters.All.Single(one => one.Name == name);

    private static Position MuzzleOf(DemoShooter shooter) => new(shooter.CellId, shooter.Origin);

    private PhysicsBody Spawn(string name, uint id)
    {
        DemoSpawn spawn = DemoSpawns.All.Single(one => one.Name == name);
        PhysicsBody body = files.CreateBody(engine, id, spawn);
        Assert.True(body.EnterWorld(DemoFiles.PlaceOf(spawn)));
        return body;
    }

    private List<MissileHit> Fire(DemoShooter shooter, out PhysicsBody missile, double seconds)
    {
        missile = missiles.Launch(arrow, MuzzleOf(shooter), shooter.Velocity, shooter.Falls)!;
        Assert.NotNull(missile);
        return Run(seconds);
    }

    private List<MissileHit> Run(double seconds)
    {
        List<MissileHit> hits = [];
        for (int end = frames + (int)Math.Round(seconds * 30); frames < end;)
        {
            engine.Tick(++frames * FrameTime);
            missiles.Update();
            while (missiles.TryTakeHit(out MissileHit hit)) hits.Add(hit);
        }

        return hits;
    }
}
