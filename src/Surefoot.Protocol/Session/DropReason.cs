namespace Surefoot.Protocol.Session;

/// <summary>Why a datagram, or a message in it, was not used.</summary>
public enum DropReason
{
    /// <summary>It was used.</summary>
    None,

    /// <summary>It is shorter than a header, or than its header says.</summary>
    TooShort,

    /// <summary>Its optional headers are cut short, or bytes are left over.</summary>
    BadOptions,

    /// <summary>A fragment is cut short or contradicts itself.</summary>
    BadFragment,

    /// <summary>It is another session's or another server's.</summary>
    Foreign,

    /// <summary>Its checksum is wrong, or made with a word of the key stream that is not due.</summary>
    Checksum,

    /// <summary>It arrived before.</summary>
    Duplicate,

    /// <summary>Its number is too far ahead.</summary>
    TooFarAhead,

    /// <summary>Too many packets are outstanding.</summary>
    TooManyMissing,

    /// <summary>It has no place in the present state of the session.</summary>
    Unexpected,

    /// <summary>A message is too long, has no opcode, or its fragments contradict each other.</summary>
    BadMessage,

    /// <summary>A bounded queue is full.</summary>
    NoRoom,
}
