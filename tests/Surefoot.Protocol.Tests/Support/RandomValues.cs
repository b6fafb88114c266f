using System.Numerics;
using System.Reflection;
using Surefoot.Protocol.Messages;

namespace Surefoot.Protocol.Tests.Support;

/// <summary>Random values of any message or part of one, such as its writer can write.</summary>
internal sealed class RandomValues(int seed)
{
    private static readonly string Letters = WireTextLetters();
    private readonly Random random = new(seed);

    public T Of<T>() => (T)Of(typeof(T))!;

    private object? Of(Type type)
    {
        if (type.IsByRef)
            return Of(type.GetElementType()!);
        if (Nullable.GetUnderlyingType(type) is { } inner)
            return Chance() ? Of(inner) : null;
        if (type.IsGenericType && type.GetGenericTypeDefinition() == typeof(ValueList<>))
            return List(type.GetGenericArguments()[0], random.Next(4));
        return Number(type) ?? Special(type) ?? Composed(type);
    }

    private object? Number(Type type) => Type.GetTypeCode(type) switch
    {
        TypeCode.Boolean => Chance(),
        TypeCode.Byte => (byte)Bits(),
        TypeCode.UInt16 => (ushort)Bits(),
        TypeCode.UInt32 => (uint)Bits(),
        TypeCode.Int32 => (int)Bits(),
        TypeCode.Int64 => (long)Bits(),
        TypeCode.UInt64 => Bits(),
        TypeCode.Single => Chance() ? BitConverter.UInt32BitsToSingle((uint)Bits()) : random.Next(-3, 4) * 0.5f,
        TypeCode.Double => Chance() ? BitConverter.UInt64BitsToDouble(Bits()) : random.Next(-3, 4) * 0.5,
        TypeCode.String => Text(),
        _ => type == typeof(Vector3) ? new Vector3(Of<float>(), Of<float>(), Of<float>())
            : type == typeof(Quaternion) ? new Quaternion(Of<float>(), Of<float>(), Of<float>(), Of<float>())
            : null,
    };

    /// <summary>Types whose parts hang together.</summary>
    private object? Special(Type type)
    {
        if (type == typeof(MotionAction))
            return new MotionAction(Of<ushort>(), (ushort)(Of<ushort>() & 0x7FFF), Chance(), Of<float>());
        if (type == typeof(MotionActions))
            return new MotionActions(Several<MotionAction>(random.Next(4) == 0 ? random.Next(32) : 0));
        if (type == typeof(MovementData))
            return Movement();
        if (type == typeof(PositionAndMovement))
            return Together(Of<UpdatePosition>(), Of<UpdateMotion>());
        if (type == typeof(ModelData))
            return Model();
        if (type == typeof(PhysicsDescription))
            return Physics((PhysicsDescription)Composed(type));
        if (type == typeof(WeenieDescription))
            return Weenie((WeenieDescription)Composed(type));
        if (type == typeof(Enchantment))
            return Spelled((Enchantment)Composed(type));
        if (type == typeof(EnchantmentRegistry))
            return Registry();
        if (type == typeof(PlayerDescription))
            return Player((PlayerDescription)Composed(type));
        if (type == typeof(CharacterBelongings))
            return (CharacterBelongings)Composed(type) with { SpellBars = [.. Several<ValueList<uint>>(8)] };
        if (type == typeof(CharacterCreate))
            return ((CharacterCreate)Composed(type)) with { Appearance = [.. Several<uint>(14)], Hues = [.. Several<double>(6)] };
        if (type == typeof(CharacterCreateResponse))
            return Chance() ? new CharacterCreateResponse(1, Of<CharacterEntry>()) : new CharacterCreateResponse(3, null);
        if (type == typeof(SetTurbineChatChannels))
            return new SetTurbineChatChannels([.. Several<uint>(10)]);
        return type == typeof(IterationSet) ? Iterations() : null;
    }

    private MovementData Movement() => random.Next(5) switch
    {
        0 => MovementData.Motion(Of<ushort>(), Of<WireInterpretedMotion>(), Chance() ? Of<uint>() : 0, Chance()),
        1 => MovementData.MoveToObject(Of<ushort>(), Of<uint>(), Of<uint>(), Of<Vector3>(), Of<MoveToParams>(), Of<float>()),
        2 => MovementData.MoveToPosition(Of<ushort>(), Of<uint>(), Of<Vector3>(), Of<MoveToParams>(), Of<float>()),
        3 => MovementData.TurnToObject(Of<ushort>(), Of<uint>(), Of<float>(), Of<uint>(), Of<float>(), Of<float>()),
        _ => MovementData.TurnToHeading(Of<ushort>(), Of<uint>(), Of<float>(), Of<float>()),
    };

    private static PositionAndMovement Together(UpdatePosition position, UpdateMotion motion)
        => new(position, motion with { Guid = position.Guid, Instance = position.Pack.Instance });

    private ModelData Model()
    {
        PaletteChange[] palettes = Several(random.Next(3), () => new PaletteChange(Packed(0x04000000), Of<byte>(), Of<byte>()));
        return new ModelData
        {
            BasePalette = palettes.Length > 0 ? Packed(0x04000000) : 0,
            Palettes = [.. palettes],
            Textures = [.. Several(random.Next(3), () => new TextureChange(Of<byte>(), Packed(0x05000000), Packed(0x05000000)))],
            Parts = [.. Several(random.Next(3), () => new PartChange(Of<byte>(), Packed(0x01000000)))],
        };
    }

    private static PhysicsDescription Physics(PhysicsDescription any)
        => any.Movement is null ? any with { Autonomous = 0 } : any with { Placement = null };

    private WeenieDescription Weenie(WeenieDescription any)
    {
        WeenieDescription weenie = any with
        {
            ClassId = Of<uint>() & 0x7FFFFFFF,
            Icon = Packed(0x06000000),
            IconOverlay = any.IconOverlay is null ? null : Packed(0x06000000),
            IconUnderlay = any.IconUnderlay is null ? null : Packed(0x06000000),
            PluralName = Chance() ? null : any.PluralName,
            Restrictions = Chance() ? null : any.Restrictions,
        };
        return weenie.Flags2 == 0 ? weenie : weenie with { Description = weenie.Description | 0x04000000 };
    }

    private static Enchantment Spelled(Enchantment any) => any.HasSpellSet == 0 ? any with { SpellSet = 0 } : any;

    private EnchantmentRegistry Registry()
    {
        uint mask = (uint)random.Next(16);
        return new EnchantmentRegistry(mask, List(1), List(2), List(8), (mask & 4) != 0 ? Of<Enchantment>() : null);

        ValueList<Enchantment> List(uint bit) => (mask & bit) != 0 ? Of<ValueList<Enchantment>>() : default;
    }

    private PlayerDescription Player(PlayerDescription any)
    {
        bool told = Chance(), plain = Chance();
        return any with
        {
            Attributes = told ? any.Attributes : null,
            Vitals = told ? any.Vitals : null,
            Enchantments = Chance() ? any.Enchantments : null,
            Belongings = plain ? any.Belongings : null,
            Rest = plain ? default : any.Rest,
        };
    }

    private IterationSet Iterations()
    {
        var entries = new List<int>();
        int total = 0;
        for (int runs = random.Next(4); runs > 0; runs--)
        {
            int length = random.Next(1, 50), start = random.Next(1000);
            entries.AddRange(length == 1 ? [start] : [-length, start]);
            total += length;
        }

        return new IterationSet(total, [.. entries]);
    }

    private object Composed(Type type)
    {
        ParameterInfo[] parameters = type.GetConstructors().MaxBy(c => c.GetParameters().Length)?.GetParameters() ?? [];
        object value = Activator.CreateInstance(type, parameters.Select(p => Of(p.ParameterType)).ToArray())!;
        if (parameters.Length > 0)
            return value;
        foreach (PropertyInfo property in type.GetProperties().Where(p => p.SetMethod is { IsPublic: true }))
            property.SetValue(value, Of(property.PropertyType));
        return value;
    }

    private object List(Type element, int count)
    {
        Array elements = Array.CreateInstance(element, count);
        for (int i = 0; i < count; i++)
            elements.SetValue(Of(element), i);
        return Activator.CreateInstance(
            typeof(ValueList<>).MakeGenericType(element), BindingFlags.Instance | BindingFlags.NonPublic, null, [elements], null)!;
    }

    private T[] Several<T>(int count) => Several(count, Of<T>);

    private static T[] Several<T>(int count, Func<T> make) => [.. Enumerable.Range(0, count).Select(_ => make())];

    private uint Packed(uint baseId) => baseId + (uint)(random.Next(3) switch
    {
        0 => random.Next(0x8000),
        1 => random.Next(0x8000, 0x10000),
        _ => random.Next(0x40000000),
    });

    private string Text() => string.Concat(Enumerable.Range(0, random.Next(12)).Select(_ => Letters[random.Next(Letters.Length)]));

    private bool Chance() => random.Next(2) == 0;

    private ulong Bits() => random.Next(4) switch
    {
        0 => (ulong)random.Next(4),
        1 => ulong.MaxValue - (ulong)random.Next(4),
        _ => (ulong)random.NextInt64() ^ ((ulong)random.Next(2) << 63),
    };

    private static string WireTextLetters() => WireText.CodePage.GetString(Enumerable.Range(0, 256).Select(i => (byte)i).ToArray());
}
