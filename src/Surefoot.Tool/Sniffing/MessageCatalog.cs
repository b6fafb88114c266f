using System.Numerics;
using System.Reflection;
using System.Text.Json;
using System.Text.Json.Nodes;
using System.Text.Json.Serialization;
using Surefoot.Protocol.Messages;

namespace Surefoot.Tool.Sniffing;

/// <summary>Every message type of the protocol, by what it is on the wire.</summary>
internal sealed class MessageCatalog
{
    private static readonly JsonSerializerOptions Json = new()
    {
        PropertyNamingPolicy = JsonNamingPolicy.CamelCase,
        NumberHandling = JsonNumberHandling.AllowNamedFloatingPointLiterals,
        DefaultIgnoreCondition = JsonIgnoreCondition.WhenWritingNull,
        IncludeFields = true,
        Converters = { new JsonStringEnumConverter(), new ActionsConverter(), new VectorConverter(), new RotationConverter() },
    };

    private readonly ILookup<MessageId, ReadFields> readers;

    internal MessageCatalog()
    {
        MethodInfo read = typeof(MessageCatalog).GetMethod(nameof(Entry), BindingFlags.NonPublic | BindingFlags.Static)!;
        readers = typeof(IMessage<>).Assembly.GetTypes()
            .Where(type => !type.IsInterface && !type.IsAbstract && IsMessage(type))
            .Select(type => ((MessageId Id, ReadFields Read))read.MakeGenericMethod(type).Invoke(null, null)!)
            .ToLookup(entry => entry.Id, entry => entry.Read);
    }

    private delegate JsonNode? ReadFields(in WireMessage message, out int unread);

    /// <summary>How many kinds of messages it knows.</summary>
    internal int Count => readers.Count;

    /// <summary>The fields of a message; null when it is unknown or damaged. Where two types share a number, the better fit.</summary>
    internal JsonNode? Fields(in WireMessage message)
    {
        JsonNode? best = null;
        int least = int.MaxValue;
        foreach (ReadFields read in readers[message.Id])
        {
            JsonNode? fields = read(message, out int unread);
            if (fields is null || unread >= least)
                continue;
            (best, least) = (fields, unread);
        }

        return best;
    }

    private static bool IsMessage(Type type)
        => type.GetInterfaces().Any(i => i.IsGenericType && i.GetGenericTypeDefinition() == typeof(IMessage<>));

    private static (MessageId Id, ReadFields Read) Entry<T>()
        where T : IMessage<T>
    {
        return (T.Id, Read);

        static JsonNode? Read(in WireMessage message, out int unread)
            => message.TryRead(out T value, out unread, out _) ? JsonSerializer.SerializeToNode(value, Json) : null;
    }

    /// <summary>Writes a type that knows nothing of JSON as an array.</summary>
    private abstract class ArrayConverter<T> : JsonConverter<T>
    {
        public override T Read(ref Utf8JsonReader reader, Type typeToConvert, JsonSerializerOptions options)
            => throw new NotSupportedException("Messages are only written as JSON.");
    }

    private sealed class ActionsConverter : ArrayConverter<MotionActions>
    {
        public override void Write(Utf8JsonWriter writer, MotionActions value, JsonSerializerOptions options)
            => JsonSerializer.Serialize(writer, value.Span.ToArray(), options);
    }

    private sealed class VectorConverter : ArrayConverter<Vector3>
    {
        public override void Write(Utf8JsonWriter writer, Vector3 value, JsonSerializerOptions options)
            => JsonSerializer.Serialize(writer, (float[])[value.X, value.Y, value.Z], options);
    }

    // w, x, y, z, as everywhere else.
    private sealed class RotationConverter : ArrayConverter<Quaternion>
    {
        public override void Write(Utf8JsonWriter writer, Quaternion value, JsonSerializerOptions options)
            => JsonSerializer.Serialize(writer, (float[])[value.W, value.X, value.Y, value.Z], options);
    }
}
