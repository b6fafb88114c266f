using System.Globalization;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace Surefoot.Tool.Sniffing;

/// <summary>The fields of a message on one line: <c>guid=0x50000001 contact=true velocity=[0, 4, 7]</c>.</summary>
internal static class FieldText
{
    private const int Longest = 400;

    // Numbers that people know by their hexadecimal digits.
    private static readonly string[] Ids = ["guid", "cell", "command", "style", "state", "target", "parent", "child", "setup", "table"];

    /// <summary>The line, cut where nobody would read on.</summary>
    internal static string Of(JsonNode fields)
    {
        string text = fields is JsonObject members ? Members(members) : Value("", fields);
        return text.Length <= Longest ? text : $"{text[..Longest]} ... (--json has it all)";
    }

    private static string Members(JsonObject members)
        => string.Join(' ', members.Select(member => $"{member.Key}={Value(member.Key, member.Value)}"));

    private static string Value(string name, JsonNode? node) => node switch
    {
        null => "none",
        JsonObject inner => $"{{{Members(inner)}}}",
        JsonArray list => $"[{string.Join(", ", list.Select(element => Value(name, element)))}]",
        JsonValue value when value.GetValueKind() == JsonValueKind.String => Quoted(value.GetValue<string>()),
        JsonValue value when IsId(name) && uint.TryParse(value.ToJsonString(), CultureInfo.InvariantCulture, out uint id) => $"0x{id:X8}",
        _ => node.ToJsonString(),
    };

    private static bool IsId(string name) => Ids.Any(id => name.EndsWith(id, StringComparison.OrdinalIgnoreCase));

    // Whatever came over the wire is no command to a terminal.
    private static string Quoted(string text) => $"\"{string.Concat(text.Select(Plain))}\"";

    private static string Plain(char character) => char.IsControl(character) ? $"\\x{(int)character:X2}" : character.ToString();
}
