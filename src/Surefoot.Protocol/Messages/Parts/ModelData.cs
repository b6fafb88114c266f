namespace Surefoot.Protocol.Messages;

/// <summary>Colours of a range of a palette.</summary>
/// <param name="Palette">Palette that they come from.</param>
/// <param name="Offset">First colour, in eighths.</param>
/// <param name="Length">Number of colours, in eighths.</param>
public readonly record struct PaletteChange(uint Palette, byte Offset, byte Length);

/// <summary>A texture of a part in place of another one.</summary>
/// <param name="Part">Index of the part.</param>
/// <param name="Old">Texture that goes.</param>
/// <param name="New">Texture that comes.</param>
public readonly record struct TextureChange(byte Part, uint Old, uint New);

/// <summary>A mesh in place of a part's own.</summary>
/// <param name="Part">Index of the part.</param>
/// <param name="Model">The mesh.</param>
public readonly record struct PartChange(byte Part, uint Model);

/// <summary>What an object looks like, as changes of its setup (specification 08, 6.6).</summary>
/// <remarks>Retail: ObjDesc::UnPack @0x005ABCF0.</remarks>
public sealed record ModelData
{
    private const byte Mark = 0x11;
    private const uint PaletteIds = 0x04000000, TextureIds = 0x05000000, ModelIds = 0x01000000;

    /// <summary>The palette that the changes begin from; travels only when there are changes of palettes, and is 0 else.</summary>
    public uint BasePalette { get; init; }

    /// <summary>At most 255.</summary>
    public ValueList<PaletteChange> Palettes { get; init; }

    /// <summary>At most 255.</summary>
    public ValueList<TextureChange> Textures { get; init; }

    /// <summary>At most 255.</summary>
    public ValueList<PartChange> Parts { get; init; }

    internal static ModelData Read(ref WireReader reader)
    {
        if (reader.ReadByte() != Mark)
            reader.Fail(WireFault.BadValue);
        uint palettes = reader.ReadByte(), textures = reader.ReadByte(), parts = reader.ReadByte();
        var model = new ModelData
        {
            BasePalette = palettes > 0 ? reader.ReadPackedId(PaletteIds) : 0,
            Palettes = reader.ReadList(
                palettes, 4, static (ref r) => new PaletteChange(r.ReadPackedId(PaletteIds), r.ReadByte(), r.ReadByte())),
            Textures = reader.ReadList(
                textures, 5, static (ref r) => new TextureChange(r.ReadByte(), r.ReadPackedId(TextureIds), r.ReadPackedId(TextureIds))),
            Parts = reader.ReadList(parts, 3, static (ref r) => new PartChange(r.ReadByte(), r.ReadPackedId(ModelIds))),
        };
        reader.Align4();
        return model;
    }

    internal void Write(ref WireWriter writer)
    {
        writer.WriteByte(Mark);
        writer.WriteByte((byte)writer.CountOf(Palettes.Count, byte.MaxValue));
        writer.WriteByte((byte)writer.CountOf(Textures.Count, byte.MaxValue));
        writer.WriteByte((byte)writer.CountOf(Parts.Count, byte.MaxValue));
        if (Palettes.Count > 0)
            writer.WritePackedId(BasePalette, PaletteIds);
        foreach (PaletteChange change in Palettes)
        {
            writer.WritePackedId(change.Palette, PaletteIds);
            writer.WriteByte(change.Offset);
            writer.WriteByte(change.Length);
        }

        foreach (TextureChange change in Textures)
        {
            writer.WriteByte(change.Part);
            writer.WritePackedId(change.Old, TextureIds);
            writer.WritePackedId(change.New, TextureIds);
        }

        foreach (PartChange change in Parts)
        {
            writer.WriteByte(change.Part);
            writer.WritePackedId(change.Model, ModelIds);
        }

        writer.Align4();
    }
}
