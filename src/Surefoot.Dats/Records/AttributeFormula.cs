namespace Surefoot.Dats.Records;

/// <summary>How attributes make a vital or a skill: (X·first + Y·second) / Z + W (spec 07, 7.17).</summary>
/// <param name="W">What is added.</param>
/// <param name="X">Weight of the first attribute.</param>
/// <param name="Y">Weight of the second attribute.</param>
/// <param name="Z">Divisor of the weighted sum.</param>
/// <param name="Attribute1">First attribute: 1 strength, 2 endurance, 3 quickness, 4 coordination, 5 focus, 6 self; 0 for none.</param>
/// <param name="Attribute2">Second attribute; 0 for none.</param>
public readonly record struct AttributeFormula(uint W, uint X, uint Y, uint Z, uint Attribute1, uint Attribute2)
{
    internal const int Size = 24;

    internal static AttributeFormula Read(ref DatReader reader) => new(
        reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadUInt32(), reader.ReadUInt32());

    internal void Write(DatWriter writer)
        => writer.WriteUInt32Array([W, X, Y, Z, Attribute1, Attribute2]);
}
