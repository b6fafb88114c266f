using System.Globalization;
using System.Numerics;
using System.Text.Json;

namespace Surefoot.Tool.Conformance.Steering;

/// <summary>The notation of recorded runs: ids as upper-case hexadecimal strings, quaternions as w, x, y, z.</summary>
internal static class VectorJson
{
    internal static uint Id(this JsonElement text) => uint.Parse(text.GetString()!, NumberStyles.HexNumber, CultureInfo.InvariantCulture);

    internal static Vector3 Vector(this JsonElement v) => new(v[0].GetSingle(), v[1].GetSingle(), v[2].GetSingle());

    internal static Quaternion Rotation(this JsonElement q) => new(q[1].GetSingle(), q[2].GetSingle(), q[3].GetSingle(), q[0].GetSingle());

    internal static bool Flag(this JsonElement number) => number.GetInt32() != 0;
}
