using System.Text;

namespace Surefoot.Protocol.Session;

/// <summary>The first packet of a client (specification 08, 3.1). The password is in no text made of it.</summary>
/// <param name="Version">Version of the client; servers of the field want "1802".</param>
/// <param name="AuthType">2: account and password.</param>
/// <param name="AuthFlags">0.</param>
/// <param name="Stamp">Any number, such as the time.</param>
/// <param name="Account">Name of the account.</param>
/// <param name="Password">At most 127 characters.</param>
/// <remarks>Retail: ClientNet::SendLoginRequest @0x00543F90.</remarks>
public sealed record LoginRequest(string Version, uint AuthType, uint AuthFlags, uint Stamp, string Account, string Password)
{
    /// <summary>The version that servers of the field want.</summary>
    public const string LiveVersion = "1802";

    /// <summary>Account and password.</summary>
    public const uint PasswordAuth = 2;

    /// <summary>Longest account name that servers of the field take.</summary>
    public const int MostAccount = 50;

    /// <summary>Longest password that has a form on the wire.</summary>
    public const int MostPassword = 127;

    /// <summary>Reads a body.</summary>
    /// <returns>Null when it is cut short.</returns>
    internal static LoginRequest? TryRead(ReadOnlySpan<byte> body)
    {
        var reader = new WireReader(body);
        string version = reader.ReadString16();
        reader.ReadUInt32();
        uint type = reader.ReadUInt32(), flags = reader.ReadUInt32(), stamp = reader.ReadUInt32();
        string account = reader.ReadString16();
        reader.ReadUInt32();
        uint length = reader.ReadUInt32();
        string password = "";
        if (length > 0)
        {
            reader.ReadByte();
            password = WireText.CodePage.GetString(reader.ReadBytes((int)Math.Min(length - 1, ushort.MaxValue)));
        }

        return reader.Fault == WireFault.None ? new LoginRequest(version, type, flags, stamp, account, password) : null;
    }

    internal void Write(ref WireWriter writer)
    {
        if (Password.Length > MostPassword)
            writer.Fail();
        writer.WriteString16(Version);
        int length = writer.Position;
        writer.WriteUInt32(0);
        writer.WriteUInt32(AuthType);
        writer.WriteUInt32(AuthFlags);
        writer.WriteUInt32(Stamp);
        writer.WriteString16(Account);
        writer.WriteUInt32(0);
        writer.WriteUInt32((uint)Password.Length + 1);
        writer.WriteByte((byte)Password.Length);
        Span<byte> password = stackalloc byte[MostPassword];
        writer.WriteBytes(password[..WireText.CodePage.GetBytes(Password.AsSpan(0, Math.Min(Password.Length, MostPassword)), password)]);
        writer.Align4();
        writer.PatchUInt32(length, (uint)(writer.Position - length - 4));
    }

    private bool PrintMembers(StringBuilder builder)
    {
        builder.Append($"Version = {Version}, AuthType = {AuthType}, AuthFlags = {AuthFlags}, Stamp = {Stamp}, Account = {Account}");
        return true;
    }
}
