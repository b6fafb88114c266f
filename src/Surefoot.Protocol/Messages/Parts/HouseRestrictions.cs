namespace Surefoot.Protocol.Messages;

/// <summary>Somebody who may enter a house.</summary>
/// <param name="Guid">Who.</param>
/// <param name="Flags">What is allowed.</param>
public readonly record struct HouseGuest(uint Guid, uint Flags);

/// <summary>Who may enter a house (specification 08, 6.7, RestrictionDB).</summary>
/// <param name="Version">Version of the list.</param>
/// <param name="Open">1 when everybody may.</param>
/// <param name="Monarch">Allegiance that may.</param>
/// <param name="Buckets">Says nothing.</param>
/// <param name="Guests">Who may.</param>
public sealed record HouseRestrictions(uint Version, uint Open, uint Monarch, ushort Buckets, ValueList<HouseGuest> Guests)
{
    internal static HouseRestrictions Read(ref WireReader reader)
    {
        uint version = reader.ReadUInt32(), open = reader.ReadUInt32(), monarch = reader.ReadUInt32();
        ushort count = reader.ReadUInt16(), buckets = reader.ReadUInt16();
        return new HouseRestrictions(
            version, open, monarch, buckets, reader.ReadList(count, 8, static (ref r) => new HouseGuest(r.ReadUInt32(), r.ReadUInt32())));
    }

    internal void Write(ref WireWriter writer)
    {
        writer.WriteUInt32(Version);
        writer.WriteUInt32(Open);
        writer.WriteUInt32(Monarch);
        writer.WriteTable(Guests, Buckets, static (ref w, guest) =>
        {
            w.WriteUInt32(guest.Guid);
            w.WriteUInt32(guest.Flags);
        });
    }
}
