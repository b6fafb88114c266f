using Surefoot.Protocol.Messages;

namespace Surefoot.Tool.Conformance.Captures;

internal static partial class CaptureFields
{
    private static ReadMessage? ReadObject(in WireMessage message) => message.Id.Opcode switch
    {
        Opcode.PlayerCreate => As<PlayerCreate>(message, m => new Fields { ["guid"] = m.Guid }),
        Opcode.CreateObject => As<CreateObject>(message, m => new Fields
        {
            ["guid"] = m.Object.Guid,
            ["model"] = Of(m.Object.Model),
            ["physics"] = Of(m.Object.Physics),
            ["weenie"] = Of(m.Object.Weenie),
        }),
        Opcode.DeleteObject => As<DeleteObject>(message, m => new Fields { ["guid"] = m.Guid, ["instance"] = m.Instance }),
        Opcode.UpdatePosition => As<UpdatePosition>(message, Of),
        Opcode.ParentEvent => As<ParentEvent>(message, m => new Fields
        {
            ["parent"] = m.Parent,
            ["child"] = m.Child,
            ["location"] = m.Location,
            ["placement"] = m.Placement,
            ["parentInstance"] = m.ParentInstance,
            ["positionStamp"] = m.PositionStamp,
        }),
        Opcode.PickupEvent => As<PickupEvent>(message, m => new Fields
        {
            ["guid"] = m.Guid,
            ["instance"] = m.Instance,
            ["positionStamp"] = m.PositionStamp,
        }),
        Opcode.SetState => As<SetState>(message, m => new Fields
        {
            ["guid"] = m.Guid,
            ["state"] = m.State,
            ["instance"] = m.Instance,
            ["stateStamp"] = m.StateStamp,
        }),
        Opcode.UpdateMotion => As<UpdateMotion>(message, m => new Fields
        {
            ["guid"] = m.Guid,
            ["instance"] = m.Instance,
            ["movementStamp"] = m.MovementStamp,
            ["serverControlledMoveStamp"] = m.ServerControlledMove,
            ["autonomous"] = m.Autonomous,
            ["movement"] = Of(m.Movement),
        }),
        Opcode.VectorUpdate => As<VectorUpdate>(message, m => new Fields
        {
            ["guid"] = m.Guid,
            ["velocity"] = m.Velocity,
            ["omega"] = m.Omega,
            ["instance"] = m.Instance,
            ["vectorStamp"] = m.VectorStamp,
        }),
        Opcode.Sound => As<Sound>(message, m => new Fields { ["guid"] = m.Guid, ["sound"] = m.SoundId, ["volume"] = m.Volume }),
        Opcode.PlayScriptType => As<PlayScriptType>(message, m => new Fields
        {
            ["guid"] = m.Guid,
            ["script"] = m.Script,
            ["speed"] = m.Speed,
        }),
        Opcode.PlayerTeleport => As<PlayerTeleport>(message, m => new Fields { ["teleportStamp"] = m.Teleport }),
        Opcode.ObjDescEvent => As<ObjDescEvent>(message, m => new Fields
        {
            ["guid"] = m.Guid,
            ["model"] = Of(m.Model),
            ["instance"] = m.Instance,
            ["objDescStamp"] = m.ObjDescStamp,
        }),
        _ => null,
    };

    private static Fields Of(UpdatePosition m)
    {
        const uint HasVelocity = 1, HasPlacement = 2;
        PositionPack pack = m.Pack;
        return new Fields
        {
            ["guid"] = m.Guid,
            ["flags"] = pack.Flags,
            ["cell"] = pack.Position.Cell,
            ["origin"] = pack.Position.Origin,
            ["orientation"] = pack.Position.Orientation,
            ["contact"] = pack.Contact,
            ["velocity"] = (pack.Flags & HasVelocity) != 0 ? pack.Velocity : null,
            ["placement"] = (pack.Flags & HasPlacement) != 0 ? pack.Placement : null,
            ["instance"] = pack.Instance,
            ["positionStamp"] = pack.PositionStamp,
            ["teleportStamp"] = pack.Teleport,
            ["forcePositionStamp"] = pack.ForcePosition,
        };
    }

    private static Fields Of(WirePosition position) => new()
    {
        ["cell"] = position.Cell,
        ["origin"] = position.Origin,
        ["orientation"] = position.Orientation,
    };

    private static Fields Of(WireRawMotion m) => new()
    {
        ["flags"] = (uint)m.Fields,
        ["currentHoldKey"] = If(m.Fields, RawMotionFields.CurrentHoldKey, m.CurrentHoldKey),
        ["currentStyle"] = If(m.Fields, RawMotionFields.CurrentStyle, m.CurrentStyle),
        ["forwardCommand"] = If(m.Fields, RawMotionFields.ForwardCommand, m.ForwardCommand),
        ["forwardHoldKey"] = If(m.Fields, RawMotionFields.ForwardHoldKey, m.ForwardHoldKey),
        ["forwardSpeed"] = If(m.Fields, RawMotionFields.ForwardSpeed, m.ForwardSpeed),
        ["sidestepCommand"] = If(m.Fields, RawMotionFields.SidestepCommand, m.SidestepCommand),
        ["sidestepHoldKey"] = If(m.Fields, RawMotionFields.SidestepHoldKey, m.SidestepHoldKey),
        ["sidestepSpeed"] = If(m.Fields, RawMotionFields.SidestepSpeed, m.SidestepSpeed),
        ["turnCommand"] = If(m.Fields, RawMotionFields.TurnCommand, m.TurnCommand),
        ["turnHoldKey"] = If(m.Fields, RawMotionFields.TurnHoldKey, m.TurnHoldKey),
        ["turnSpeed"] = If(m.Fields, RawMotionFields.TurnSpeed, m.TurnSpeed),
        ["actions"] = Of(m.Actions),
    };

    private static Fields Of(WireInterpretedMotion m) => new()
    {
        ["flags"] = (uint)m.Fields,
        ["style"] = If(m.Fields, InterpretedMotionFields.Style, m.Style),
        ["forwardCommand"] = If(m.Fields, InterpretedMotionFields.ForwardCommand, m.ForwardCommand),
        ["forwardSpeed"] = If(m.Fields, InterpretedMotionFields.ForwardSpeed, m.ForwardSpeed),
        ["sidestepCommand"] = If(m.Fields, InterpretedMotionFields.SidestepCommand, m.SidestepCommand),
        ["sidestepSpeed"] = If(m.Fields, InterpretedMotionFields.SidestepSpeed, m.SidestepSpeed),
        ["turnCommand"] = If(m.Fields, InterpretedMotionFields.TurnCommand, m.TurnCommand),
        ["turnSpeed"] = If(m.Fields, InterpretedMotionFields.TurnSpeed, m.TurnSpeed),
        ["actions"] = Of(m.Actions),
    };

    private static Fields Of(MovementData m)
    {
        bool isState = m.Type == MovementType.InterpretedMotion, isTurn = m.Type is MovementType.TurnToObject or MovementType.TurnToHeading;
        bool isMove = m.Type is MovementType.MoveToObject or MovementType.MoveToPosition;
        return new Fields
        {
            ["type"] = (byte)m.Type,
            ["motionFlags"] = m.MotionFlags,
            ["style"] = m.Style,
            ["state"] = isState ? Of(m.State) : null,
            ["target"] = m.Type is MovementType.MoveToObject or MovementType.TurnToObject ? m.Target : null,
            ["cell"] = isMove ? m.Cell : null,
            ["origin"] = isMove ? m.Origin : null,
            ["desiredHeading"] = m.Type == MovementType.TurnToObject ? m.DesiredHeading : null,
            ["parameters"] = isState ? null : new Fields
            {
                ["bits"] = m.Parameters.Bits,
                ["distanceToObject"] = isTurn ? null : m.Parameters.DistanceToObject,
                ["minDistance"] = isTurn ? null : m.Parameters.MinDistance,
                ["failDistance"] = isTurn ? null : m.Parameters.FailDistance,
                ["speed"] = m.Parameters.Speed,
                ["walkRunThreshold"] = isTurn ? null : m.Parameters.WalkRunThreshold,
                ["desiredHeading"] = m.Parameters.DesiredHeading,
            },
            ["runRate"] = isMove ? m.RunRate : null,
        };
    }

    private static Fields Of(ModelData m) => new()
    {
        ["basePalette"] = m.Palettes.Count > 0 ? m.BasePalette : null,
        ["palettes"] = m.Palettes.Select(c => new[] { c.Palette, c.Offset, c.Length }),
        ["textures"] = m.Textures.Select(c => new[] { c.Part, c.Old, c.New }),
        ["parts"] = m.Parts.Select(c => new[] { c.Part, c.Model }),
    };

    private static Fields Of(PhysicsDescription m) => new()
    {
        ["flags"] = m.Flags,
        ["state"] = m.State,
        ["movement"] = m.Movement is { } movement ? Of(movement) : null,
        ["autonomous"] = m.Movement is null ? null : m.Autonomous,
        ["placement"] = m.Placement,
        ["position"] = m.Position is { } position ? Of(position) : null,
        ["motionTable"] = m.MotionTable,
        ["soundTable"] = m.SoundTable,
        ["scriptTable"] = m.ScriptTable,
        ["setup"] = m.Setup,
        ["parent"] = m.Parent is { } parent ? new[] { parent.Guid, parent.Location } : null,
        ["children"] = m.Children?.Select(child => new[] { child.Guid, child.Location }),
        ["scale"] = m.Scale,
        ["friction"] = m.Friction,
        ["elasticity"] = m.Elasticity,
        ["translucency"] = m.Translucency,
        ["velocity"] = m.Velocity,
        ["acceleration"] = m.Acceleration,
        ["omega"] = m.Omega,
        ["defaultScript"] = m.DefaultScript,
        ["defaultScriptIntensity"] = m.DefaultScriptIntensity,
        ["stamps"] = new Fields
        {
            ["position"] = m.Stamps.Position,
            ["movement"] = m.Stamps.Movement,
            ["state"] = m.Stamps.State,
            ["vector"] = m.Stamps.Vector,
            ["teleport"] = m.Stamps.Teleport,
            ["serverControlledMove"] = m.Stamps.ServerControlledMove,
            ["forcePosition"] = m.Stamps.ForcePosition,
            ["objDesc"] = m.Stamps.ObjDesc,
            ["instance"] = m.Stamps.Instance,
        },
    };

    private static IEnumerable<Fields> Of(MotionActions actions) => actions.Span.ToArray().Select(action => new Fields
    {
        ["command"] = action.Command,
        ["stamp"] = action.Stamp,
        ["autonomous"] = action.Autonomous,
        ["speed"] = action.Speed,
    });

    private static object? If<TFlags>(TFlags fields, TFlags flag, object value)
        where TFlags : struct, Enum => fields.HasFlag(flag) ? value : null;
}
