using System.Numerics;
using Surefoot.Physics.World;

namespace Surefoot.Client.Tests;

public class PositionReportTests
{
    [Fact]
    [Behaviour("controller.sends.position-each-second-of-movement", "spec/08, 5.6")]
    public void A_position_is_told_after_a_second_and_only_when_it_changed()
    {
        KeyFixture f = new();
        Assert.Single(f.Sent.Positions);
        f.Press(MovementKeys.None, 90);
        Assert.Single(f.Sent.Positions);
        f.Position = new Position(0xA9B40001, new Vector3(13, 12, 0));
        f.Press(MovementKeys.None);
        Assert.Equal(2, f.Sent.Positions.Count);
        Assert.True(f.Sent.Positions[1].Contact);
        f.Position = new Position(0xA9B40001, new Vector3(14, 12, 0));
        f.Press(MovementKeys.None, 29);
        Assert.Equal(2, f.Sent.Positions.Count);
        f.Press(MovementKeys.None, 3);
        Assert.Equal(3, f.Sent.Positions.Count);
    }

    [Fact]
    [Behaviour("controller.sends.position-at-once-on-a-new-cell-or-plane", "spec/08, 5.6; spec/09b, 14.9 P12")]
    public void A_new_cell_or_plane_is_told_at_once_and_nothing_from_the_air()
    {
        KeyFixture f = new();
        f.Position = new Position(0xA9B40002, new Vector3(12, 25, 0));
        f.Press(MovementKeys.None);
        Assert.Equal(2, f.Sent.Positions.Count);
        f.ContactPlane = new Plane(0, 0, 1, -0.5f);
        f.Press(MovementKeys.None);
        Assert.Equal(3, f.Sent.Positions.Count);

        f.SetOnWalkable(false);
        f.Position = new Position(0xA9B40003, new Vector3(12, 49, 5));
        f.Press(MovementKeys.None, 60);
        Assert.Equal(3, f.Sent.Positions.Count);
        f.SetOnWalkable(true);
        f.Press(MovementKeys.None);
        Assert.Equal(4, f.Sent.Positions.Count);
    }

    [Fact]
    [Behaviour("controller.sends.move-to-state-delays-the-position", "spec/08, 5.6; spec/09b, 14.9 P13")]
    public void A_move_to_state_counts_as_a_position_in_time()
    {
        KeyFixture f = Told();
        f.Controller.Update(MovementKeys.Forward, 100.8);
        f.Position = new Position(0xA9B40019, new Vector3(84, 12.1f, 94));
        f.Controller.Update(MovementKeys.Forward, 101.4);
        f.Controller.Update(MovementKeys.Forward, 101.8);
        Assert.Empty(f.Sent.Positions);
        f.Controller.Update(MovementKeys.Forward, 101.81);
        Assert.Single(f.Sent.Positions);
    }

    [Fact]
    [Behaviour("controller.sends.move-to-state-keeps-cell-and-plane", "spec/09b, 9.8")]
    public void After_a_move_to_state_a_new_cell_is_still_told()
    {
        KeyFixture f = Told();
        f.Position = f.Position with { CellId = 0xA9B4001A };
        f.Controller.Update(MovementKeys.Forward, 100.02);
        Assert.Single(f.Sent.Moves);
        Assert.Equal(0xA9B4001Au, Assert.Single(f.Sent.Positions).Position.Cell);
    }

    [Theory]
    [Behaviour("controller.sends.position-when-due", "spec/09b, 14.9 P1 to P11")]
    [InlineData(100.9, 5f, 0.0, 0xA9B40019u, 0f, 1f, -94f, false)]
    [InlineData(101.0, 5f, 0.0, 0xA9B40019u, 0f, 1f, -94f, false)]
    [InlineData(101.01, 5f, 0.0, 0xA9B40019u, 0f, 1f, -94f, true)]
    [InlineData(105.0, 0.0001f, 0.0, 0xA9B40019u, 0f, 1f, -94f, false)]
    [InlineData(105.0, 0.0003f, 0.0, 0xA9B40019u, 0f, 1f, -94f, true)]
    [InlineData(105.0, 0f, 0.02, 0xA9B40019u, 0f, 1f, -94f, false)]
    [InlineData(105.0, 0f, 0.03, 0xA9B40019u, 0f, 1f, -94f, true)]
    [InlineData(100.02, 0f, 0.0, 0xA9B4001Au, 0f, 1f, -94f, true)]
    [InlineData(100.02, 0f, 0.0, 0xA9B40019u, 0f, 1f, -94.5f, true)]
    [InlineData(100.02, 0f, 0.0, 0xA9B40019u, 0.1f, 0.995f, -94f, true)]
    [InlineData(101.5, 0f, 0.0, 0xA9B40019u, 0f, 1f, -94.5f, false)]
    public void A_position_is_due_when_it_says_something_new(
        double now, float moved, double turned, uint cell, float normalY, float normalZ, float d, bool due)
    {
        KeyFixture f = Told();
        Position position = new(cell, new Vector3(84 + moved, 7.1f, 94));
        double half = turned * Math.PI / 360;
        position.Frame.SetRotation(new Quaternion(0, 0, (float)Math.Sin(half), (float)Math.Cos(half)));
        f.Position = position;
        f.ContactPlane = new Plane(0, normalY, normalZ, d);
        f.Controller.Update(MovementKeys.None, now);
        Assert.Equal(due ? 1 : 0, f.Sent.Positions.Count);
    }

    /// <summary>Told where it is at 100 s.</summary>
    private static KeyFixture Told()
    {
        KeyFixture f =
            new() { Now = 100, Position = new Position(0xA9B40019, new Vector3(84, 7.1f, 94)), ContactPlane = new Plane(0, 0, 1, -94) };
        f.Controller.Update(MovementKeys.None, 100);
        f.Sent.Positions.Clear();
        return f;
    }
}
