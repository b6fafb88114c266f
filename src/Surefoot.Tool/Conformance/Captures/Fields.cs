using System.Collections;
using System.Numerics;
using System.Text.Json;

namespace Surefoot.Tool.Conformance.Captures;

/// <summary>Fields by name, as the recordings have them; those that are null are absent.</summary>
internal sealed class Fields : IEnumerable<KeyValuePair<string, object>>
{
    private readonly Dictionary<string, object> values = [];

    public object? this[string name]
    {
        set
        {
            if (value is not null)
                values.Add(name, value);
        }
    }

    public IEnumerator<KeyValuePair<string, object>> GetEnumerator() => values.GetEnumerator();

    IEnumerator IEnumerable.GetEnumerator() => GetEnumerator();

    /// <summary>Compares with what was recorded.</summary>
    /// <returns>The first difference; null when there is none.</returns>
    public string? DifferenceFrom(JsonElement expected) => Difference(expected, this, "");

    /// <summary>Compares these fields alone with what was recorded, which may have others.</summary>
    /// <returns>The first difference; null when there is none.</returns>
    public string? DifferenceWhereTold(JsonElement expected) => Difference(expected, "");

    private string? Difference(JsonElement expected, string path) => values
        .Select(field => expected.TryGetProperty(field.Key, out JsonElement value)
            ? Difference(value, field.Value, $"{path}.{field.Key}")
            : $"{path}.{field.Key} is not expected: {field.Value}")
        .FirstOrDefault(difference => difference is not null);

    private static string? Difference(JsonElement expected, object actual, string path)
    {
        switch (actual)
        {
            case Fields fields:
                if (expected.ValueKind != JsonValueKind.Object)
                    return $"{path}: {expected} expected";
                foreach (JsonProperty property in expected.EnumerateObject())
                {
                    bool isNull = property.Value.ValueKind == JsonValueKind.Null;
                    if (!isNull && !fields.values.ContainsKey(property.Name))
                        return $"{path}.{property.Name} is missing: {property.Value} expected";
                }

                return fields.Difference(expected, path);
            case Vector3 vector:
                return Difference(expected, new[] { vector.X, vector.Y, vector.Z }, path);
            case Quaternion rotation:
                return Difference(expected, new[] { rotation.W, rotation.X, rotation.Y, rotation.Z }, path);
            case string text:
                return expected.GetString() == text ? null : $"{path}: '{expected}' expected, '{text}' found";
            case bool flag:
                return expected.GetBoolean() == flag ? null : $"{path}: {expected} expected, {flag} found";
            case float number:
                return expected.GetSingle().Equals(number) ? null : $"{path}: {expected} expected, {number:R} found";
            case double number:
                return expected.GetDouble().Equals(number) ? null : $"{path}: {expected} expected, {number:R} found";
            case IEnumerable list:
                object[] elements = [.. list.Cast<object>()];
                if (expected.ValueKind != JsonValueKind.Array || expected.GetArrayLength() != elements.Length)
                    return $"{path}: {expected} expected, {elements.Length} elements found";
                return elements.Select((element, i) => Difference(expected[i], element, $"{path}[{i}]"))
                    .FirstOrDefault(difference => difference is not null);
            default:
                long integer = Convert.ToInt64(actual, null);
                return expected.GetInt64() == integer ? null : $"{path}: {expected} expected, {integer} found";
        }
    }
}
