using System.Globalization;
using Surefoot.Dats;

namespace Surefoot.Physics.World;

/// <summary>What a world does without.</summary>
public enum LeftOutKind
{
    /// <summary>A landblock with all that is in it; its id is that of its record, 0xXXYYFFFF.</summary>
    Landblock,

    /// <summary>A room with the objects in it.</summary>
    Room,

    /// <summary>
    /// A building; its id is that of its model, a setup or a mesh. Its rooms are there, but nobody enters them from outdoors.
    /// </summary>
    Building,

    /// <summary>An object of a landblock or a room; its id is that of its model.</summary>
    Object,

    /// <summary>An object of a scene; its id is that of its model.</summary>
    Scenery,

    /// <summary>A scene with all that it strews.</summary>
    Scene,

    /// <summary>An animation; the object that should play it stays at its rest pose.</summary>
    Animation,

    /// <summary>A way of putting an object down; its id is that of the setup that lacks it.</summary>
    Placement,

    /// <summary>A bit of a body's state word that contradicts another one or the body's shape; its id is that of the setup.</summary>
    StateBit,
}

/// <summary>One thing that a world does without, and why.</summary>
/// <param name="Kind">What it is.</param>
/// <param name="Id">Its id.</param>
/// <param name="Reason">Why, as a sentence without a full stop; names the record at fault where that is another one.</param>
/// <param name="File">Path of the file in which the record at fault lies; empty when it is in none.</param>
/// <param name="Offset">Bytes from the start of the record at fault; 0 for the record as a whole.</param>
public sealed record LeftOutItem(LeftOutKind Kind, uint Id, string Reason, string File = "", long Offset = 0)
{
    /// <summary>The record that names it, the first of them where there are several; 0 when it is its own.</summary>
    public uint FirstIn { get; init; }

    /// <summary>How many of this kind and id are left out for this reason.</summary>
    public long Count { get; init; } = 1;

    /// <summary>The item for a record that is missing or wrong.</summary>
    internal static LeftOutItem Of(LeftOutKind kind, uint id, uint firstIn, Exception fault)
    {
        if (fault is not DatFormatException wrong) return new LeftOutItem(kind, id, fault.Message.TrimEnd('.')) { FirstIn = firstIn };
        string reason = wrong.RecordId is uint culprit && culprit != id ? $"record 0x{culprit:X8}: {wrong.Reason}" : wrong.Reason;
        return new LeftOutItem(kind, id, reason, wrong.File, wrong.Offset) { FirstIn = firstIn };
    }

    /// <summary>All of it in one line, for people.</summary>
    public override string ToString()
    {
        string times = Count == 1 ? "" : $" × {Count}";
        string first = FirstIn == 0 ? "" : $", {(Count == 1 ? "" : "first ")}in 0x{FirstIn:X8}";
        string place = File.Length == 0 ? "" : $" ({Path.GetFileName(File)}, offset 0x{Offset:X})";
        return string.Create(CultureInfo.InvariantCulture, $"{Kind} 0x{Id:X8}{times}{first}: {Reason}{place}");
    }
}
