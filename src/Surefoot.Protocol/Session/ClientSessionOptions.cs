using System.Text;
using Surefoot.Protocol.Messages;

namespace Surefoot.Protocol.Session;

/// <summary>Who logs in, and how patient the client is. The password is in no text made of it.</summary>
public sealed record ClientSessionOptions
{
    private readonly string account = "", password = "";

    /// <summary>Name of the account: 1 to 50 printable characters of ASCII.</summary>
    /// <exception cref="ArgumentException">Another text.</exception>
    public required string Account
    {
        get => account;
        init => account = value.Length is > 0 and <= LoginRequest.MostAccount && WireText.IsPlain(value)
            ? value
            : throw new ArgumentException($"An account name has 1 to {LoginRequest.MostAccount} printable characters of ASCII.");
    }

    /// <summary>The password: at most 127 printable characters of ASCII.</summary>
    /// <exception cref="ArgumentException">Another text.</exception>
    public required string Password
    {
        get => password;
        init => password = value.Length <= LoginRequest.MostPassword && WireText.IsPlain(value)
            ? value
            : throw new ArgumentException($"A password has at most {LoginRequest.MostPassword} printable characters of ASCII.");
    }

    /// <summary>Version of the client, which servers compare.</summary>
    public string Version { get; init; } = LoginRequest.LiveVersion;

    /// <summary>Goes into the login request; servers ignore it.</summary>
    public uint Stamp { get; init; }

    /// <summary>What dat files to tell of; none is accepted by servers of the field.</summary>
    public ValueList<DatFileState> DatFiles { get; init; }

    /// <summary>How long the login may take until the characters are known, seconds.</summary>
    public double LoginTimeout { get; init; } = 30;

    /// <summary>How long a connected server may be silent, seconds: retail's 140 by default. Servers of the field say something every two
    /// seconds.</summary>
    public double SilenceTimeout { get; init; } = 140;

    private bool PrintMembers(StringBuilder builder)
    {
        builder.Append($"Account = {Account}, Version = {Version}, LoginTimeout = {LoginTimeout}, SilenceTimeout = {SilenceTimeout}");
        return true;
    }
}
