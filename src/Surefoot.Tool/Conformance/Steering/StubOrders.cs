using System.Text.Json;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;

namespace Surefoot.Tool.Conformance.Steering;

/// <summary>Orders to a <see cref="StubBody"/> to go somewhere, through the common entry of the move-to manager.</summary>
internal static class StubOrders
{
    /// <summary>Gives the order that an event names.</summary>
    internal static void Give(StubBody body, JsonElement e)
    {
        switch (e[0].GetString())
        {
            case "move-to-object" when body.Find(e[2].Id()) is { } target:
                Begin(body).MoveToObject(TopLevelOf(target), target.Radius, target.Height, ParametersIn(e[3]));
                break;
            case "turn-to-object" when body.Find(e[2].Id()) is { } target:
                Begin(body).TurnToObject(TopLevelOf(target), ParametersIn(e[3]));
                break;
            case "move-to-position":
                Begin(body).MoveToPosition(StubSettings.PositionIn(e[2], e[3], e[4]), ParametersIn(e[5]));
                break;
            case "turn-to-heading":
                TurnToHeading(body, e[2]);
                break;
            case "move-to-object" or "turn-to-object":
                break;
            default:
                throw new InvalidDataException($"the event {e} is not known.");
        }
    }

    /// <summary>Orders a turn to a heading.</summary>
    internal static void TurnToHeading(StubBody body, JsonElement parameters) => Begin(body).TurnToHeading(ParametersIn(parameters));

    private static MoveToManager Begin(StubBody body)
    {
        MoveToManager manager = body.MakeMoveTo();
        manager.Interrupt();
        return manager;
    }

    private static uint TopLevelOf(SteeredBody target) => target.ParentId != 0 ? target.ParentId : target.Id;

    private static MovementParameters ParametersIn(JsonElement p) => new()
    {
        Flags = (MovementFlags)p.GetProperty("flags").Id(),
        DistanceToObject = p.GetProperty("dist").GetSingle(),
        MinDistance = p.GetProperty("min").GetSingle(),
        FailDistance = p.GetProperty("fail").GetSingle(),
        DesiredHeading = p.GetProperty("heading").GetSingle(),
        Speed = p.GetProperty("speed").GetSingle(),
        WalkRunThreshold = p.GetProperty("threshold").GetSingle(),
        HoldKey = (HoldKey)p.GetProperty("hold").GetInt32(),
    };
}
