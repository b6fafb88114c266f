namespace Surefoot.Protocol.Messages;

/// <summary>The queue that a message travels in: the last field of a fragment's header (specification 08, 2.5). Order is kept within a
/// group only.</summary>
public enum MessageGroup : ushort
{
    /// <summary>Requests about the session's objects.</summary>
    Control = 2,

    /// <summary>What a client does in the world: all game actions.</summary>
    World = 3,

    /// <summary>Character selection, from the client.</summary>
    Logon = 4,

    /// <summary>Exchange about versions of the dat files.</summary>
    Database = 5,

    /// <summary>From the server: the character, the account, texts.</summary>
    Interface = 9,

    /// <summary>From the server: objects and their movement.</summary>
    Objects = 10,
}
