using System.Text.Json;

namespace Surefoot.Tool.Conformance.Steering;

/// <summary>Outcome of one recorded run of the managers.</summary>
/// <param name="Id">Name of the case.</param>
/// <param name="Family">What it drives.</param>
/// <param name="Tag">What it aims at.</param>
/// <param name="IsTight">One of its decisions hangs on the last bit of a float.</param>
/// <param name="Entries">Quanta or messages recorded.</param>
/// <param name="Equal">Entries that came out the same before the first that did not.</param>
/// <param name="Difference">What differs there; null when nothing does.</param>
internal sealed record ManagerResult(string Id, string Family, string Tag, bool IsTight, int Entries, int Equal, string? Difference)
{
    internal static ManagerResult Of(JsonElement recorded, int entries, int equal, string? difference) => new(
        recorded.GetProperty("id").GetString()!, recorded.GetProperty("family").GetString()!, recorded.GetProperty("tag").GetString()!,
        recorded.TryGetProperty("tight", out JsonElement tight) && tight.Flag(), entries, equal, difference);
}
