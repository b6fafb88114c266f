using System.Numerics;
using System.Text.Json;
using Surefoot.Physics.Motion;
using Surefoot.Physics.Steering;
using Surefoot.Physics.World;

namespace Surefoot.Tool.Conformance.Steering;

/// <summary>A heading, which counts modulo a full circle.</summary>
internal readonly record struct Degrees(float Value);

/// <summary>A time of the clock.</summary>
internal readonly record struct Moment(double Seconds);

/// <summary>
/// Compares what a replay gives with what was recorded: flags, counts and ids exactly, numbers to the tolerances of the recording.
/// </summary>
internal static class Tolerance
{
    /// <summary>Is a value the recorded one?</summary>
    internal static bool Same(object actual, JsonElement recorded) => actual switch
    {
        string text => text == recorded.GetString(),
        uint id => Id(id, recorded),
        MotionCommand motion => Id((uint)motion, recorded),
        bool flag => flag == recorded.Flag(),
        int number => recorded.ValueKind == JsonValueKind.Number && recorded.GetDouble() == number,
        float number => Number(number, recorded),
        double number => Number(number, recorded),
        Degrees heading => Heading(heading.Value, recorded),
        Moment moment => Math.Abs(moment.Seconds - recorded.GetDouble()) <= 1e-9,
        Vector3 v => Number(v.X, recorded[0]) && Number(v.Y, recorded[1]) && Number(v.Z, recorded[2]),
        Quaternion q => Rotation(q, recorded),
        TargetInfo info => Report(info, recorded),
        object[] items => recorded.ValueKind == JsonValueKind.Array && Items(items, recorded),
        _ => throw new InvalidOperationException($"There is no comparison of {actual.GetType().Name}."),
    };

    /// <summary>
    /// Is a call the recorded one? Positions are three items there, and the reason of a cancelled move-to has no effect in retail.
    /// </summary>
    internal static bool SameCall(object[] actual, JsonElement recorded) => actual[0] is "cancel"
        ? recorded[0].GetString() == "cancel" && Same(actual[1], recorded[1])
        : Items([.. actual.SelectMany(Spread)], recorded);

    private static IEnumerable<object> Spread(object item) =>
        item is Position p ? [p.CellId, p.Frame.Origin, p.Frame.Rotation] : [item];

    private static bool Items(object[] actual, JsonElement recorded)
    {
        if (actual.Length != recorded.GetArrayLength()) return false;
        for (int i = 0; i < actual.Length; i++)
        {
            if (!Same(actual[i], recorded[i])) return false;
        }

        return true;
    }

    private static bool Id(uint actual, JsonElement recorded) =>
        recorded.ValueKind == JsonValueKind.String ? actual == recorded.Id() : actual == 0 && recorded.GetInt32() == 0;

    private static bool Number(double actual, JsonElement recorded)
    {
        double expected = recorded.GetDouble();
        return Math.Abs(actual - expected) <= 2e-4 + (1e-5 * Math.Abs(expected));
    }

    private static bool Heading(float actual, JsonElement recorded)
    {
        double expected = recorded.GetDouble(), off = Math.Abs(actual - expected) % 360.0;
        return Math.Min(off, 360.0 - off) <= 2e-4 + (1e-5 * Math.Abs(expected));
    }

    private static bool Rotation(Quaternion actual, JsonElement recorded)
    {
        Quaternion expected = recorded.Rotation();
        return Within(actual - expected) || Within(actual + expected);
        static bool Within(Quaternion d) =>
            Math.Max(Math.Max(Math.Abs(d.W), Math.Abs(d.X)), Math.Max(Math.Abs(d.Y), Math.Abs(d.Z))) <= 2e-5f;
    }

    private static bool Report(in TargetInfo info, JsonElement recorded) =>
        info.ContextId == recorded.GetProperty("context").GetUInt32() &&
        Id(info.ObjectId, recorded.GetProperty("object")) &&
        (int)info.Status == recorded.GetProperty("status").GetInt32() &&
        Number(info.Radius, recorded.GetProperty("radius")) &&
        Number(info.Quantum, recorded.GetProperty("quantum")) &&
        Place(info.TargetPosition, recorded.GetProperty("cell"), recorded.GetProperty("pos")) &&
        Place(info.InterpolatedPosition, recorded.GetProperty("icell"), recorded.GetProperty("ipos")) &&
        Same(info.Velocity, recorded.GetProperty("vel")) &&
        Same(info.InterpolatedHeading, recorded.GetProperty("toward"));

    private static bool Place(in Position actual, JsonElement cell, JsonElement origin) =>
        Id(actual.CellId, cell) && Same(actual.Frame.Origin, origin);
}
