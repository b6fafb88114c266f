namespace Surefoot.Protocol.Messages;

/// <summary>The client has arrived: sent once after entering the world and after every teleport (specification 08, 3.5).</summary>
public readonly record struct LoginComplete : IGameAction<LoginComplete>
{
    static GameActionType IGameAction<LoginComplete>.Type => GameActionType.LoginComplete;

    static LoginComplete IMessage<LoginComplete>.Read(ref WireReader reader) => default;

    void IMessage<LoginComplete>.Write(ref WireWriter writer)
    {
    }
}

/// <summary>Asks for a sign of life (specification 08, 5.6).</summary>
public readonly record struct RequestPing : IGameAction<RequestPing>
{
    static GameActionType IGameAction<RequestPing>.Type => GameActionType.RequestPing;

    static RequestPing IMessage<RequestPing>.Read(ref WireReader reader) => default;

    void IMessage<RequestPing>.Write(ref WireWriter writer)
    {
    }
}
