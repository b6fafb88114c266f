using System.Numerics;
using Surefoot.Physics.Geometry;
using Surefoot.Physics.World;

namespace Surefoot.Physics.Bodies;

/// <summary>FNV-1a over the bits of a state, 64 bits wide.</summary>
internal struct StateHash()
{
    internal ulong Value { get; private set; } = 0xCBF29CE484222325;

    internal void Add(ulong bits)
    {
        for (int i = 0; i < 8; i++)
        {
            Value = (Value ^ (bits & 0xFF)) * 0x100000001B3;
            bits >>= 8;
        }
    }

    internal void Add(float value) => Add(BitConverter.SingleToUInt32Bits(value));

    internal void Add(double value) => Add(BitConverter.DoubleToUInt64Bits(value));

    internal void Add(in Position value)
    {
        Add(value.CellId);
        Add(value.Frame);
    }

    internal void Add(in Frame value)
    {
        Add(value.Origin);
        Add(value.Rotation);
    }

    internal void Add(in Vector3 value)
    {
        Add(value.X);
        Add(value.Y);
        Add(value.Z);
    }

    internal void Add(in Quaternion value)
    {
        Add(value.X);
        Add(value.Y);
        Add(value.Z);
        Add(value.W);
    }
}
