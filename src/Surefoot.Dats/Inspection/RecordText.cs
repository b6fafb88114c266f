using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;
using System.Text.Json.Serialization;
using System.Text.Json.Serialization.Metadata;
using Surefoot.Dats.Records;

namespace Surefoot.Dats;

/// <summary>Any record as indented text for people or as JSON for programs: <c>surefoot dats show</c>.</summary>
public static class RecordText
{
    private const int LineLength = 120;

    private static readonly JsonSerializerOptions Options = CreateOptions(indented: false);

    private static readonly JsonSerializerOptions IndentedOptions = CreateOptions(indented: true);

    /// <summary>The record as JSON. Ids are texts such as "0x01000001", vectors [x, y, z], rotations [w, x, y, z].</summary>
    /// <param name="record">The record.</param>
    /// <param name="indented">Over several lines.</param>
    public static string ToJson(DatRecord record, bool indented = true)
        => JsonSerializer.Serialize<object>(record, indented ? IndentedOptions : Options);

    /// <summary>The record as JSON nodes, e.g. to put into a larger answer.</summary>
    public static JsonNode ToJsonNode(DatRecord record) => JsonSerializer.SerializeToNode<object>(record, Options)!;

    /// <summary>The record as indented text, a member a line; short lists on one line.</summary>
    public static string ToText(DatRecord record)
    {
        var text = new StringBuilder();
        JsonNode members = ToJsonNode(record);
        if (record is RawRecord raw)
        {
            members["bytes"] = raw.Bytes.Length;
            Append(text, members, 0);
            AppendDump(text, raw.Bytes.AsSpan());
        }
        else
        {
            Append(text, members, 0);
        }

        return text.ToString();
    }

    private static void Append(StringBuilder text, JsonNode? node, int depth)
    {
        if (node is JsonObject members)
        {
            foreach (var (name, value) in members)
                AppendMember(text, name, value, depth);
        }
        else if (node is JsonArray elements)
        {
            for (int i = 0; i < elements.Count; i++)
                AppendMember(text, $"[{i}]", elements[i], depth);
        }
    }

    private static void AppendMember(StringBuilder text, string name, JsonNode? value, int depth)
    {
        string indent = new(' ', depth * 2);
        string? line = InOneLine(value, LineLength - indent.Length - name.Length);
        text.Append(indent).Append(name);
        if (line is not null)
        {
            text.Append(": ").AppendLine(line);
        }
        else if (value is JsonArray numbers && numbers.All(static element => element is JsonValue))
        {
            text.AppendLine(":");
            AppendWrapped(text, numbers, new string(' ', (depth + 1) * 2));
        }
        else
        {
            text.AppendLine(":");
            Append(text, value, depth + 1);
        }
    }

    private static void AppendWrapped(StringBuilder text, JsonArray values, string indent)
    {
        int column = 0;
        foreach (JsonNode? value in values)
        {
            string word = Word(value);
            if (column > 0 && column + 1 + word.Length > LineLength)
            {
                text.AppendLine();
                column = 0;
            }

            text.Append(column == 0 ? indent : " ").Append(word);
            column += (column == 0 ? indent.Length : 1) + word.Length;
        }

        text.AppendLine();
    }

    private static void AppendDump(StringBuilder text, ReadOnlySpan<byte> bytes)
    {
        const int row = 16;
        for (int i = 0; i < bytes.Length; i += row)
        {
            text.Append($"{i:X4} ");
            foreach (byte value in bytes[i..Math.Min(i + row, bytes.Length)])
                text.Append($" {value:X2}");
            text.AppendLine();
        }
    }

    // Null when it does not fit, or is a list of objects or lists.
    private static string? InOneLine(JsonNode? node, int width)
    {
        string? line = node switch
        {
            JsonArray { Count: 0 } => "none",
            JsonArray list when list.All(static element => element is JsonValue) => $"({string.Join(' ', list.Select(Word))})",
            JsonArray => null,
            JsonObject members when members.All(static member => member.Value is JsonValue or null || IsFlat(member.Value))
                => string.Join(", ", members.Select(static member => $"{member.Key} {InOneLine(member.Value, int.MaxValue)}")),
            JsonObject => null,
            _ => Word(node),
        };
        return line is not null && line.Length <= width ? line : node is JsonValue ? line : null;
    }

    private static bool IsFlat(JsonNode node) => node is JsonArray list
        ? list.All(static element => element is JsonValue)
        : node.AsObject().All(static member => member.Value is JsonValue or null || (member.Value is JsonArray && IsFlat(member.Value)));

    private static string Word(JsonNode? value) => value?.ToString() switch
    {
        null => "none",
        "4294967295" => "0xFFFFFFFF",
        string word => word,
    };

    private static JsonSerializerOptions CreateOptions(bool indented)
    {
        var resolver = new DefaultJsonTypeInfoResolver();
        resolver.Modifiers.Add(WriteIdsInHexadecimal);
        resolver.Modifiers.Add(OmitWhatNodesDoNotStore);
        return new JsonSerializerOptions
        {
            WriteIndented = indented,
            IncludeFields = false,
            NumberHandling = JsonNumberHandling.AllowNamedFloatingPointLiterals,
            PropertyNamingPolicy = JsonNamingPolicy.CamelCase,
            Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping,
            TypeInfoResolver = resolver,
            Converters =
            {
                new JsonStringEnumConverter(),
                new Vector3Converter(),
                new QuaternionConverter(),
                new PlaneConverter(),
            },
        };
    }

    // Members named …Id or …Ids, cells, and keys and styles of motion tables are what people look up in hexadecimal.
    private static void WriteIdsInHexadecimal(JsonTypeInfo type)
    {
        bool isMotion = type.Type.Name.Contains("Motion", StringComparison.Ordinal);
        foreach (JsonPropertyInfo member in type.Properties)
        {
            bool isId = member.Name.EndsWith("id", StringComparison.OrdinalIgnoreCase)
                || member.Name.EndsWith("ids", StringComparison.OrdinalIgnoreCase)
                || member.Name is "otherCell" or "stabCells" or "visibleCells"
                || (isMotion && member.PropertyType == typeof(uint));
            if (type.Type == typeof(RawRecord) && member.Name == "bytes")
                member.CustomConverter = new HexBytesConverter();
            else if (isId && HexadecimalConverter.Handles(member.PropertyType))
                member.CustomConverter = new HexadecimalConverter();
        }
    }

    private static void OmitWhatNodesDoNotStore(JsonTypeInfo type)
    {
        if (type.Type != typeof(BspNode))
            return;
        foreach (JsonPropertyInfo member in type.Properties)
        {
            Func<BspNode, bool>? stores = member.Name switch
            {
                "plane" => static node => !node.IsLeaf,
                "positive" => static node => node.Positive != BspNode.None,
                "negative" => static node => node.Negative != BspNode.None,
                "leafIndex" or "solid" => static node => node.IsLeaf,
                "portals" => static node => !node.Portals.IsEmpty,
                _ => null,
            };
            if (stores is not null)
                member.ShouldSerialize = (node, _) => stores((BspNode)node);
        }
    }
}
