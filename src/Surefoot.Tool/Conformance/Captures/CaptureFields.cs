using Surefoot.Protocol;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Tool.Conformance.Captures;

/// <summary>A message of a recording, read as its type.</summary>
/// <param name="Fields">Its fields; null for a type that the recordings give none for.</param>
/// <param name="Unread">Bytes behind them.</param>
/// <param name="Fault">Why it cannot be read, or is not the same when it is written again; null when it can, and is.</param>
internal sealed record ReadMessage(Fields? Fields, int Unread, string? Fault = null);

/// <summary>Names the fields of messages as the recordings do.</summary>
internal static partial class CaptureFields
{
    /// <summary>Reads a message as the type that we have for it; null when there is none.</summary>
    public static ReadMessage? Read(WireDirection direction, in WireMessage message) => message.Id.Opcode switch
    {
        Opcode.GameAction => ReadAction(message),
        Opcode.GameEvent => ReadEvent(message),
        _ => ReadPlain(direction, message),
    };

    private static ReadMessage? ReadAction(in WireMessage message) => message.Id.Action switch
    {
        GameActionType.MoveToState => As<MoveToState>(message, m => new Fields
        {
            ["rawState"] = Of(m.Motion),
            ["position"] = Of(m.Position),
            ["instance"] = m.Stamps.Instance,
            ["serverControlledMoveStamp"] = m.Stamps.ServerControlledMove,
            ["teleportStamp"] = m.Stamps.Teleport,
            ["forcePositionStamp"] = m.Stamps.ForcePosition,
            ["contact"] = m.Contact,
            ["standingLongJump"] = m.StandingLongJump,
        }),
        GameActionType.Jump => As<Jump>(message, m => new Fields
        {
            ["extent"] = m.Extent,
            ["velocity"] = m.Velocity,
            ["position"] = Of(m.Position),
            ["instance"] = m.Stamps.Instance,
            ["serverControlledMoveStamp"] = m.Stamps.ServerControlledMove,
            ["teleportStamp"] = m.Stamps.Teleport,
            ["forcePositionStamp"] = m.Stamps.ForcePosition,
        }),
        GameActionType.AutonomousPosition => As<AutonomousPosition>(message, m => new Fields
        {
            ["position"] = Of(m.Position),
            ["instance"] = m.Stamps.Instance,
            ["serverControlledMoveStamp"] = m.Stamps.ServerControlledMove,
            ["teleportStamp"] = m.Stamps.Teleport,
            ["forcePositionStamp"] = m.Stamps.ForcePosition,
            ["contact"] = m.Contact,
        }),
        GameActionType.LoginComplete => As<LoginComplete>(message, _ => []),
        GameActionType.RequestPing => As<RequestPing>(message, _ => []),
        GameActionType.Talk => As<Talk>(message, m => new Fields { ["text"] = m.Text }),
        GameActionType.Use => As<Use>(message, m => new Fields { ["guid"] = m.Guid }),
        GameActionType.IdentifyObject => As<IdentifyObject>(message),
        GameActionType.PutItemInContainer => As<PutItemInContainer>(message),
        GameActionType.GetAndWieldItem => As<GetAndWieldItem>(message),
        GameActionType.DropItem => As<DropItem>(message),
        GameActionType.RaiseVital => As<RaiseVital>(message),
        GameActionType.RaiseAttribute => As<RaiseAttribute>(message),
        GameActionType.RaiseSkill => As<RaiseSkill>(message),
        GameActionType.TrainSkill => As<TrainSkill>(message),
        GameActionType.ChangeCombatMode => As<ChangeCombatMode>(message),
        _ => null,
    };

    private static ReadMessage? ReadEvent(in WireMessage message) => message.Id.Event switch
    {
        GameEventType.PlayerDescription => As<PlayerDescription>(message, Of),
        GameEventType.Popup => As<Popup>(message, m => new Fields { ["text"] = m.Text }),
        GameEventType.Titles => As<Titles>(message, m => new Fields { ["one"] = m.One, ["title"] = m.Title, ["titles"] = m.Known }),
        GameEventType.Friends => As<Friends>(message, m => new Fields { ["friends"] = 0, ["kind"] = m.Kind }),
        GameEventType.UseDone => As<UseDone>(message, m => new Fields { ["error"] = m.Error }),
        GameEventType.PingResponse => As<PingResponse>(message, _ => []),
        GameEventType.ItemServerSaysContainId => As<ItemServerSaysContainId>(message),
        GameEventType.WieldItem => As<WieldItem>(message),
        GameEventType.InventoryPutObjectIn3D => As<InventoryPutObjectIn3D>(message),
        GameEventType.WeenieError => As<WeenieError>(message),
        GameEventType.WeenieErrorWithString => As<WeenieErrorWithString>(message),
        GameEventType.SetTurbineChatChannels => As<SetTurbineChatChannels>(message),
        _ => null,
    };

    private static ReadMessage? ReadPlain(WireDirection direction, in WireMessage message) => message.Id.Opcode switch
    {
        Opcode.CharacterLogOff when direction == WireDirection.ClientToServer
            => As<LogOffRequest>(message, m => new Fields { ["guid"] = m.Guid }),
        Opcode.CharacterLogOff => As<LogOffReply>(message, _ => []),
        Opcode.CharacterCreate => As<CharacterCreate>(message, Of),
        Opcode.CharacterCreateResponse => As<CharacterCreateResponse>(message, m => new Fields
        {
            ["result"] = m.Result,
            ["guid"] = m.Character?.Guid,
            ["name"] = m.Character?.Name,
            ["deletion"] = m.Character?.Deletion,
        }),
        Opcode.CharacterEnterWorld => As<CharacterEnterWorld>(message, m => new Fields { ["guid"] = m.Guid, ["account"] = m.Account }),
        Opcode.CharacterEnterWorldRequest => As<CharacterEnterWorldRequest>(message, _ => []),
        Opcode.EnterWorldServerReady => As<EnterWorldServerReady>(message, _ => []),
        Opcode.CharacterList => As<CharacterList>(message, Of),
        Opcode.CharacterError => As<CharacterError>(message, m => new Fields { ["code"] = m.Code }),
        Opcode.AccountBoot => As<AccountBoot>(message, m => new Fields { ["reason"] = m.Reason }),
        Opcode.ServerName => As<ServerName>(message, m => new Fields { ["online"] = m.Online, ["max"] = m.Most, ["name"] = m.Name }),
        Opcode.DddInterrogation => As<DddInterrogation>(message, m => new Fields
        {
            ["region"] = m.Region,
            ["nameRuleLanguage"] = m.NameRuleLanguage,
            ["product"] = m.Product,
            ["languages"] = m.Languages,
        }),
        Opcode.DddInterrogationResponse => As<DddInterrogationResponse>(message, m => new Fields
        {
            ["language"] = m.Language,
            ["lists"] = m.Files,
            ["noKeys"] = m.NoKeys,
            ["flags"] = m.Flags,
        }),
        Opcode.DddEnd => As<DddEnd>(message, _ => []),
        Opcode.Chat => As<Chat>(message, m => new Fields { ["text"] = m.Text, ["type"] = m.Kind }),
        Opcode.HearSpeech => As<HearSpeech>(message),
        Opcode.PrivateUpdatePropertyInt => As<PrivateUpdatePropertyInt>(message, m => new Fields
        {
            ["seq"] = m.Sequence,
            ["property"] = m.Property,
            ["value"] = m.Value,
        }),
        Opcode.PublicUpdatePropertyInt => As<PublicUpdatePropertyInt>(message, m => new Fields
        {
            ["seq"] = m.Sequence,
            ["guid"] = m.Guid,
            ["property"] = m.Property,
            ["value"] = m.Value,
        }),
        Opcode.PrivateUpdatePropertyInt64 => As<PrivateUpdatePropertyInt64>(message),
        Opcode.PublicUpdatePropertyInstanceId => As<PublicUpdatePropertyInstanceId>(message),
        Opcode.PrivateUpdateSkill => As<PrivateUpdateSkill>(message, m => new Fields
        {
            ["seq"] = m.Sequence,
            ["skill"] = m.Skill,
            ["record"] = Of(m.Record),
        }),
        Opcode.PrivateUpdateAttribute => As<PrivateUpdateAttribute>(message, m => new Fields
        {
            ["seq"] = m.Sequence,
            ["attribute"] = m.Attribute,
            ["record"] = Of(m.Record),
        }),
        Opcode.PrivateUpdateVital => As<PrivateUpdateVital>(message, m => new Fields
        {
            ["seq"] = m.Sequence,
            ["vital"] = m.Vital,
            ["record"] = Of(m.Record),
        }),
        Opcode.PrivateUpdateAttribute2ndLevel => As<PrivateUpdateAttribute2ndLevel>(message, m => new Fields
        {
            ["seq"] = m.Sequence,
            ["vital"] = m.Vital,
            ["current"] = m.Current,
        }),
        _ => ReadObject(message),
    };

    private static ReadMessage As<T>(in WireMessage message, Func<T, Fields>? fields = null)
        where T : IMessage<T>
    {
        if (!message.TryRead(out T value, out int unread, out WireFault fault))
            return new ReadMessage(null, message.Body.Length, $" cannot be read: {fault}");
        byte[] buffer = new byte[1 << 16];
        bool isWritten = WireMessage.TryWrite(value, buffer, out int length, message.Stamp, message.Guid);
        string? difference = unread != 0 ? $" leaves {unread} bytes unread"
            : isWritten && message.Bytes.SequenceEqual(buffer.AsSpan(0, length)) ? null
            : " is written with other bytes";
        return new ReadMessage(fields?.Invoke(value), unread, difference);
    }
}
