using System.Buffers.Binary;
using Surefoot.Protocol.Messages;

namespace Surefoot.Protocol.Session;

/// <summary>The first 16 bytes of a fragment (specification 08, 2.5).</summary>
/// <param name="Sequence">Number of the message at its sender.</param>
/// <param name="Id">High half of the message's id.</param>
/// <param name="Count">Fragments of the message.</param>
/// <param name="Size">Bytes of this fragment, header included.</param>
/// <param name="Index">Which of them it is.</param>
/// <param name="Group">The group that the message travels in.</param>
public readonly record struct FragmentHeader(uint Sequence, uint Id, ushort Count, ushort Size, ushort Index, MessageGroup Group)
{
    /// <summary>Bytes of the header.</summary>
    public const int Length = 16;

    /// <summary>Most bytes of a message in one fragment.</summary>
    public const int MostData = 448;

    /// <summary>Most bytes of a fragment.</summary>
    public const int MostSize = Length + MostData;

    /// <summary>The size is possible and the index is one of those that the count allows.</summary>
    internal bool IsValid => Size is >= Length and <= MostSize && Index < Count;

    /// <summary>Fragments of a message of this many bytes.</summary>
    internal static int CountFor(int messageLength) => (messageLength + MostData - 1) / MostData;

    internal static FragmentHeader Read(ReadOnlySpan<byte> bytes) => new(
        BinaryPrimitives.ReadUInt32LittleEndian(bytes),
        BinaryPrimitives.ReadUInt32LittleEndian(bytes[4..]),
        BinaryPrimitives.ReadUInt16LittleEndian(bytes[8..]),
        BinaryPrimitives.ReadUInt16LittleEndian(bytes[10..]),
        BinaryPrimitives.ReadUInt16LittleEndian(bytes[12..]),
        (MessageGroup)BinaryPrimitives.ReadUInt16LittleEndian(bytes[14..]));

    internal void Write(Span<byte> bytes)
    {
        BinaryPrimitives.WriteUInt32LittleEndian(bytes, Sequence);
        BinaryPrimitives.WriteUInt32LittleEndian(bytes[4..], Id);
        BinaryPrimitives.WriteUInt16LittleEndian(bytes[8..], Count);
        BinaryPrimitives.WriteUInt16LittleEndian(bytes[10..], Size);
        BinaryPrimitives.WriteUInt16LittleEndian(bytes[12..], Index);
        BinaryPrimitives.WriteUInt16LittleEndian(bytes[14..], (ushort)Group);
    }
}
