namespace Surefoot.Protocol;

/// <summary>Why bytes could not be read as what they were said to be.</summary>
public enum WireFault
{
    /// <summary>Nothing is wrong.</summary>
    None,

    /// <summary>The bytes end before the value does.</summary>
    Truncated,

    /// <summary>A list announces more elements than the bytes left can hold.</summary>
    CountTooLarge,

    /// <summary>A number or a flag has a value for which there is no layout.</summary>
    BadValue,

    /// <summary>The message is another one than the type that was asked for.</summary>
    OtherMessage,
}
