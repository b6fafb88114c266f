using Surefoot.Client;
using Surefoot.Protocol.Messages;

namespace Surefoot.Server.Tests.Hosting;

/// <summary>What a player's client told of some seconds of play from the start, told again by another client; then it is teleported back
/// and tells it again.</summary>
/// <param name="client">Who tells it.</param>
/// <param name="course">What is told, and when.</param>
/// <param name="begins">When it begins, seconds.</param>
internal sealed class CourseReplay(TestClient client, IReadOnlyList<(double At, object Message)> course, double begins)
{
    private const double Rest = 3, BackAfter = 1;

    private double began = begins;
    private int next;

    /// <summary>Claims told.</summary>
    internal int Told { get; private set; }

    /// <summary>Half a minute of running, turning, jumping and standing, by a real body.</summary>
    internal static List<(double At, object Message)> Record(DemoGround ground)
    {
        MovementKeys[] keys =
        [
            MovementKeys.Forward, MovementKeys.Forward | MovementKeys.TurnRight, MovementKeys.Jump, MovementKeys.TurnLeft,
            MovementKeys.Forward, MovementKeys.SidestepLeft, MovementKeys.Back, MovementKeys.None,
        ];
        SimulatedHost host = new(ground, options => options with { Spawns = [] });
        TestClient walker = host.Enter("Walker");
        List<(double At, object Message)> told = [];
        using PlayedPlayer player = new(ground, walker) { Hears = message => told.Add((host.Now, message)) };
        double begin = host.Now;
        foreach (MovementKeys held in keys)
        {
            player.Hold(held);
            host.Run(3, () => player.Frame(host.Now));
        }

        Assert.Equal(0, host.Server.Figures.AllRefusedClaims);
        return [.. told.Select(one => (one.At - begin, one.Message))];
    }

    /// <summary>Tells what is due.</summary>
    internal void Update(double now)
    {
        for (; next < course.Count && now >= began + course[next].At; next++)
        {
            Told++;
            switch (course[next].Message)
            {
                case MoveToState move:
                    client.Session.Send(move with { Stamps = client.Stamps });
                    break;
                case Jump jump:
                    client.Session.Send(jump with { Stamps = client.Stamps });
                    break;
                case AutonomousPosition place:
                    client.Session.Send(place with { Stamps = client.Stamps });
                    break;
            }
        }

        if (next < course.Count || now < began + course[^1].At + Rest) return;
        client.Session.Send(new Talk("@start"));
        client.Session.Send(new LoginComplete());
        (began, next) = (now + BackAfter, 0);
    }
}
