namespace Surefoot.Protocol.Session;

/// <summary>What a packet carries (specification 08, 2.2). Optional headers follow the packet's header in ascending order of these
/// values.</summary>
[Flags]
public enum PacketFlags : uint
{
    /// <summary>Nothing.</summary>
    None = 0,

    /// <summary>Sent again.</summary>
    Retransmission = 0x00000001,

    /// <summary>The checksum is mixed with a word of the sender's key stream.</summary>
    EncryptedChecksum = 0x00000002,

    /// <summary>Fragments of messages fill the rest.</summary>
    BlobFragments = 0x00000004,

    /// <summary>8 bytes; not sent by servers of the field.</summary>
    ServerSwitch = 0x00000100,

    /// <summary>16 bytes; not sent by servers of the field.</summary>
    LogonServerAddress = 0x00000200,

    /// <summary>32 bytes: another server; not sent by servers of the field.</summary>
    Referral = 0x00000800,

    /// <summary>Numbers of packets that did not arrive: send them again.</summary>
    RequestRetransmit = 0x00001000,

    /// <summary>Numbers of packets that are no longer there.</summary>
    RejectRetransmit = 0x00002000,

    /// <summary>The number up to which everything arrived.</summary>
    AckSequence = 0x00004000,

    /// <summary>The session is over.</summary>
    Disconnect = 0x00008000,

    /// <summary>The whole body is a login request.</summary>
    LoginRequest = 0x00010000,

    /// <summary>8 bytes; not sent to servers of the field.</summary>
    WorldLoginRequest = 0x00020000,

    /// <summary>32 bytes: the answer to a login request.</summary>
    ConnectRequest = 0x00040000,

    /// <summary>8 bytes: the answer to a connect request, to the second port.</summary>
    ConnectResponse = 0x00080000,

    /// <summary>8 bytes: an error.</summary>
    NetError = 0x00100000,

    /// <summary>8 bytes: an error that ends the session.</summary>
    NetErrorDisconnect = 0x00200000,

    /// <summary>8 bytes: a sign of life to the second port.</summary>
    CicmdCommand = 0x00400000,

    /// <summary>8 bytes: the sender's clock, seconds.</summary>
    TimeSync = 0x01000000,

    /// <summary>4 bytes: the client's clock, seconds.</summary>
    EchoRequest = 0x02000000,

    /// <summary>8 bytes: the client's clock sent back, and a number to ignore.</summary>
    EchoResponse = 0x04000000,

    /// <summary>6 bytes: how much arrived in an interval.</summary>
    Flow = 0x08000000,
}
