namespace Surefoot.Protocol.Tests.Support;

/// <summary>The bytes of specification 08, section 11: whole datagrams, but for the last.</summary>
internal static class WorkedExamples
{
    /// <summary>11.1. Account "testaccount", password "testpass", timestamp 0.</summary>
    public static byte[] LoginRequest { get; } = Hex.Bytes(
        """
        0000  00 00 00 00 00 00 01 00 CC 6C 71 11 00 00 00 00
        0010  3C 00 00 00 04 00 31 38 30 32 00 00 30 00 00 00
        0020  02 00 00 00 00 00 00 00 00 00 00 00 0B 00 74 65
        0030  73 74 61 63 63 6F 75 6E 74 00 00 00 00 00 00 00
        0040  09 00 00 00 08 74 65 73 74 70 61 73 73 00 00 00
        """);

    /// <summary>11.2. Time 1000.5, cookie 0x1122334455667788, NetID 5.</summary>
    public static byte[] ConnectRequest { get; } = Hex.Bytes(
        """
        0000  00 00 00 00 00 00 04 00 41 95 07 13 0B 00 E8 03
        0010  20 00 01 00 00 00 00 00 00 44 8F 40 88 77 66 55
        0020  44 33 22 11 05 00 00 00 78 56 34 12 F0 DE BC 9A
        0030  00 00 00 00
        """);

    /// <summary>11.3. To the second port.</summary>
    public static byte[] ConnectResponse { get; } = Hex.Bytes(
        """
        0000  00 00 00 00 00 00 08 00 B6 1B 8B 21 05 00 00 00
        0010  08 00 01 00 88 77 66 55 44 33 22 11
        """);

    /// <summary>11.4. Last sent 12, acknowledging 7.</summary>
    public static byte[] AckOnly { get; } = Hex.Bytes(
        """
        0000  0C 00 00 00 00 40 00 00 F9 B0 F9 BA 05 00 03 00
        0010  04 00 01 00 07 00 00 00
        """);

    /// <summary>11.5. NetID 5.</summary>
    public static byte[] Disconnect { get; } = Hex.Bytes(
        """
        0000  00 00 00 00 00 80 00 00 E2 F0 F2 BA 05 00 00 00
        0010  00 00 01 00
        """);

    /// <summary>11.6. Running forward by autorun: packet 6, the fifth key, message 5, blob stamp 4, action stamp 1.</summary>
    public static byte[] MoveToState { get; } = Hex.Bytes(
        """
        0000  06 00 00 00 06 00 00 00 00 19 FF 85 05 00 0A 00
        0010  58 00 01 00 05 00 00 00 04 00 00 03 01 00 58 00
        0020  00 00 03 00 B1 F7 00 00 01 00 00 00 1C F6 00 00
        0030  0D 00 00 00 02 00 00 00 05 00 00 45 02 00 00 00
        0040  19 00 B4 A9 00 00 A8 42 33 33 E3 40 00 00 BC 42
        0050  F4 35 7F 3F 00 00 00 00 00 00 00 00 2A AF A0 BD
        0060  01 00 02 00 03 00 04 00 01 00 00 00
        """);

    /// <summary>11.7. Extent 0.5, velocity (0, 4, 7): packet 7, the sixth key, message 6, blob stamp 5, action stamp 2.</summary>
    public static byte[] Jump { get; } = Hex.Bytes(
        """
        0000  07 00 00 00 06 00 00 00 51 13 33 41 05 00 0A 00
        0010  54 00 01 00 06 00 00 00 05 00 00 03 01 00 54 00
        0020  00 00 03 00 B1 F7 00 00 02 00 00 00 1B F6 00 00
        0030  00 00 00 3F 00 00 00 00 00 00 80 40 00 00 E0 40
        0040  19 00 B4 A9 00 00 A8 42 33 33 E3 40 00 00 BC 42
        0050  F4 35 7F 3F 00 00 00 00 00 00 00 00 2A AF A0 BD
        0060  01 00 02 00 03 00 04 00
        """);

    /// <summary>11.8. With an acknowledgement of 9: packet 8, the seventh key, message 7, blob stamp 6, action stamp 3.</summary>
    public static byte[] AutonomousPosition { get; } = Hex.Bytes(
        """
        0000  08 00 00 00 06 40 00 00 B8 2B 1A EA 05 00 0A 00
        0010  4C 00 01 00 09 00 00 00 07 00 00 00 06 00 00 03
        0020  01 00 48 00 00 00 03 00 B1 F7 00 00 03 00 00 00
        0030  53 F7 00 00 19 00 B4 A9 00 00 A8 42 33 33 E3 40
        0040  00 00 BC 42 F4 35 7F 3F 00 00 00 00 00 00 00 00
        0050  2A AF A0 BD 01 00 02 00 03 00 04 00 01 00 00 00
        """);

    /// <summary>11.9. 0x50000001 runs forward at 2.5: server packet 30, the first key, message 40.</summary>
    public static byte[] UpdateMotion { get; } = Hex.Bytes(
        """
        0000  1E 00 00 00 06 00 00 00 92 C9 12 A8 0B 00 14 00
        0010  30 00 01 00 28 00 00 00 00 00 00 80 01 00 30 00
        0020  00 00 0A 00 4C F7 00 00 01 00 00 50 01 00 09 00
        0030  02 00 01 00 00 00 3D 00 07 00 00 00 3D 00 07 00
        0040  00 00 20 40
        """);

    /// <summary>11.10. On the ground, without qx and qy: server packet 31, the second key, message 41.</summary>
    public static byte[] UpdatePosition { get; } = Hex.Bytes(
        """
        0000  1F 00 00 00 06 00 00 00 10 73 36 BF 0B 00 14 00
        0010  3C 00 01 00 29 00 00 00 00 00 00 80 01 00 3C 00
        0020  00 00 0A 00 48 F7 00 00 01 00 00 50 34 00 00 00
        0030  19 00 B4 A9 00 00 A8 42 33 33 E3 40 00 00 BC 42
        0040  F4 35 7F 3F 2A AF A0 BD 01 00 11 00 03 00 04 00
        """);

    /// <summary>11.11. The message only: an action, and an object to stick to.</summary>
    public static byte[] StickyMotion { get; } = Hex.Bytes(
        """
        0000  4C F7 00 00 02 00 00 50 01 00 0A 00 03 00 00 00
        0010  00 01 3D 00 82 00 00 00 05 00 87 00 03 00 00 00
        0020  80 3F 00 00 34 12 00 80
        """);
}
