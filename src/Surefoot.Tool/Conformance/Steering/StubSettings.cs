using System.Numerics;
using System.Text.Json;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.Motion;
using Surefoot.Physics.World;

namespace Surefoot.Tool.Conformance.Steering;

/// <summary>All of a <see cref="StubBody"/> but its managers: what a case sets, where the body is, and what it does.</summary>
internal sealed class StubSettings
{
    /// <summary>Place; changed in place.</summary>
    internal Position Position;

    internal StubSettings(JsonElement body)
    {
        Id = body.GetProperty("id").Id();
        Position = PositionIn(body.GetProperty("cell"), body.GetProperty("pos"), body.GetProperty("rot"));
        Radius = body.GetProperty("radius").GetSingle();
        Height = body.GetProperty("height").GetSingle();
        foreach (JsonProperty property in body.EnumerateObject()) Set(property.Name, property.Value);
    }

    internal uint Id { get; }

    internal float Radius { get; }

    internal float Height { get; }

    internal uint ParentId { get; private set; }

    internal bool IsPlayer { get; private set; }

    internal float PlayerDistance { get; set; }

    internal bool Contact { get; set; } = true;

    internal bool Walkable { get; set; } = true;

    internal bool HasCell { get; set; } = true;

    /// <summary>Share of a move that the world lets pass.</summary>
    internal double Free { get; set; } = 1;

    /// <summary>Placements are granted.</summary>
    internal bool Placing { get; set; } = true;

    internal float RunRate { get; set; } = 1;

    internal HoldKey HoldKey { get; set; } = HoldKey.None;

    internal MotionError Refusal { get; set; }

    internal int PendingAfterDo { get; private set; }

    internal int PendingAfterStop { get; private set; }

    internal int PendingAfterHalt { get; private set; }

    /// <summary>Speeds instead of those of the run rate, m/s.</summary>
    internal (float Max, float Adjusted)? Speeds { get; set; }

    /// <summary>Motion instead of that of the commands: m/s in the body's axes, and rad/s.</summary>
    internal Vector4? Root { get; set; }

    internal MotionCommand Forward { get; set; } = MotionCommand.Ready;

    internal float ForwardSpeed { get; set; } = 1;

    /// <summary>Speed of the turn, null without one.</summary>
    internal float? TurnSpeed { get; set; }

    /// <summary>Quanta for which motions are pending.</summary>
    internal int PendingQuanta { get; set; }

    internal Vector3 Velocity { get; set; }

    /// <summary>A position that a case gives as three items in a row; the quaternion as it stands.</summary>
    internal static Position PositionIn(JsonElement cell, JsonElement origin, JsonElement rotation) =>
        new(cell.Id(), new Frame(origin.Vector(), rotation.Rotation()));

    /// <summary>Quanta for which a motion begun, one ended, and a stop of everything stay pending.</summary>
    internal void SetPending(int afterDo, int afterStop, int afterHalt) =>
        (PendingAfterDo, PendingAfterStop, PendingAfterHalt) = (afterDo, afterStop, afterHalt);

    private void Set(string name, JsonElement value)
    {
        switch (name)
        {
            case "contact": Contact = value.GetInt32() != 0; break;
            case "walkable": Walkable = value.GetInt32() != 0; break;
            case "player": IsPlayer = value.GetInt32() != 0; break;
            case "parent": ParentId = value.Id(); break;
            case "runRate": RunRate = value.GetSingle(); break;
            case "holdKey": HoldKey = (HoldKey)value.GetInt32(); break;
            case "playerDistance": PlayerDistance = value.GetSingle(); break;
            case "pending": SetPending(value[0].GetInt32(), value[1].GetInt32(), value[2].GetInt32()); break;
            case "speeds": Speeds = (value[0].GetSingle(), value[1].GetSingle()); break;
            case "root": Root = new Vector4(value[0].GetSingle(), value[1].GetSingle(), value[2].GetSingle(), value[3].GetSingle()); break;
        }
    }
}
