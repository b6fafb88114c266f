using System.Runtime.ExceptionServices;
using Surefoot.Dats;

namespace Surefoot.Physics.World;

/// <summary>
/// What becomes of the faults that turn up while a landblock is built: the thing that a fault belongs to is left out, or the landblock
/// fails.
/// </summary>
/// <param name="strict">
/// Faults are thrown, except for what retail leaves out too: a building, object or scene whose own record is in no file (specification 07,
/// 9.1).
/// </param>
internal sealed class LandblockFaults(bool strict)
{
    private readonly List<LeftOutItem> items = [];

    /// <summary>What is left out so far.</summary>
    internal IReadOnlyList<LeftOutItem> Items => items;

    /// <summary>Is this what a record that is missing or wrong raises?</summary>
    internal static bool IsFault(Exception e) => e is DatFormatException or DatRecordMissingException;

    /// <summary>Leaves a thing out for a fault, or throws the fault.</summary>
    /// <param name="kind">What it is.</param>
    /// <param name="id">Its id.</param>
    /// <param name="firstIn">The record that names it; 0 when it is its own.</param>
    /// <param name="fault">Why.</param>
    internal void LeaveOut(LeftOutKind kind, uint id, uint firstIn, Exception fault)
    {
        bool isMissing = fault is DatRecordMissingException missing && missing.Id == id;
        bool asInRetail = isMissing && kind is not (LeftOutKind.Landblock or LeftOutKind.Room);
        if (strict && !asInRetail) ExceptionDispatchInfo.Throw(fault);
        items.Add(LeftOutItem.Of(kind, id, firstIn, fault));
    }

    /// <summary>
    /// Leaves out rooms that an info record promises and that are in no file: one item for all in a row, since a wrong count may promise
    /// thousands.
    /// </summary>
    internal void LeaveOutMissingRooms(uint first, uint count, uint infoId)
    {
        LeaveOut(LeftOutKind.Room, first, infoId, new DatRecordMissingException(first, DatRecordType.EnvCell, infoId));
        if (count > 1) items[^1] = items[^1] with { Count = count, Reason = $"{items[^1].Reason}, nor for the {count - 1} after it" };
    }

    /// <summary>A landblock that fails as a whole tells of that alone.</summary>
    internal void LeaveOutAll(uint recordId, Exception fault)
    {
        items.Clear();
        LeaveOut(LeftOutKind.Landblock, recordId, 0, fault);
    }
}
