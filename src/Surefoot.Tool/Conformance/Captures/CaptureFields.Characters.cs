using System.Reflection;
using Surefoot.Protocol;
using Surefoot.Protocol.Messages;

namespace Surefoot.Tool.Conformance.Captures;

internal static partial class CaptureFields
{
    private static Fields Of(CharacterList m) => new()
    {
        ["zero"] = m.Status,
        ["characters"] = m.Characters.Select(c => new Fields { ["guid"] = c.Guid, ["name"] = c.Name, ["deletion"] = c.Deletion }),
        ["slots"] = m.Slots,
        ["account"] = m.Account,
        ["useTurbineChat"] = m.UseTurbineChat,
        ["hasThroneOfDestiny"] = m.HasThroneOfDestiny,
    };

    private static Fields Of(CharacterCreate m) => new()
    {
        ["account"] = m.Account,
        ["one"] = m.One,
        ["heritage"] = m.Heritage,
        ["gender"] = m.Gender,
        ["appearance"] = m.Appearance,
        ["hues"] = m.Hues,
        ["template"] = m.Template,
        ["strength"] = m.Strength,
        ["endurance"] = m.Endurance,
        ["coordination"] = m.Coordination,
        ["quickness"] = m.Quickness,
        ["focus"] = m.Focus,
        ["self"] = m.Self,
        ["slot"] = m.Slot,
        ["classId"] = m.ClassId,
        ["skills"] = m.Skills,
        ["name"] = m.Name,
        ["startArea"] = m.StartArea,
        ["isAdmin"] = m.IsAdmin,
        ["isSentinel"] = m.IsSentinel,
    };

    /// <summary>The recordings name these fields as the type does, in camel case.</summary>
    private static Fields Of(WeenieDescription m)
    {
        var fields = new Fields { ["flags"] = m.Flags, ["flags2"] = m.Flags2 };
        foreach (PropertyInfo property in typeof(WeenieDescription).GetProperties())
            fields[char.ToLowerInvariant(property.Name[0]) + property.Name[1..]] = property.GetValue(m);
        return fields;
    }

    private static Fields Of(PlayerDescription m) => new()
    {
        ["flags"] = m.Flags,
        ["weenieType"] = m.WeenieType,
        ["ints"] = Table(m.Ints, value => value),
        ["int64s"] = Table(m.Int64s, value => value),
        ["bools"] = Table(m.Bools, value => value),
        ["doubles"] = Table(m.Doubles, value => value),
        ["strings"] = Table(m.Strings, value => value),
        ["dataIds"] = Table(m.DataIds, value => value),
        ["instanceIds"] = Table(m.InstanceIds, value => value),
        ["positions"] = Table(m.Positions, value => Of(value)),
        ["vectorFlags"] = m.Vectors,
        ["hasHealth"] = m.HasHealth,
        ["attributeMask"] = m.AttributeMask,
        ["attributes"] = new Fields
        {
            ["strength"] = Of(m.Attributes?.Strength),
            ["endurance"] = Of(m.Attributes?.Endurance),
            ["quickness"] = Of(m.Attributes?.Quickness),
            ["coordination"] = Of(m.Attributes?.Coordination),
            ["focus"] = Of(m.Attributes?.Focus),
            ["self"] = Of(m.Attributes?.Self),
        },
        ["vitals"] = new Fields
        {
            ["health"] = Of(m.Vitals?.Health),
            ["stamina"] = Of(m.Vitals?.Stamina),
            ["mana"] = Of(m.Vitals?.Mana),
        },
        ["skills"] = Table(m.Skills, Of),
        ["options"] = m.Belongings is not { } belongings ? null : new Fields
        {
            ["flags"] = 0x460,
            ["options1"] = belongings.Options1,
            ["spellBars"] = belongings.SpellBars,
            ["spellFilters"] = belongings.SpellFilters,
            ["options2"] = belongings.Options2,
        },
        ["inventory"] = m.Belongings?.Inventory.Select(item => new Fields { ["guid"] = item.Guid, ["kind"] = item.Kind }),
        ["equipment"] = m.Belongings?.Equipment.Select(item => new Fields
        {
            ["guid"] = item.Guid,
            ["location"] = item.Location,
            ["priority"] = item.Priority,
        }),
    };

    private static Fields Of(SkillRecord m) => new()
    {
        ["ranks"] = m.Ranks,
        ["version"] = m.Version,
        ["advancement"] = m.Advancement,
        ["experience"] = m.Experience,
        ["initial"] = m.Initial,
        ["resistance"] = m.Resistance,
        ["lastUsed"] = m.LastUsed,
    };

    private static Fields? Of(AttributeRecord? attribute) => attribute is not { } m ? null : new Fields
    {
        ["ranks"] = m.Ranks,
        ["start"] = m.Start,
        ["experience"] = m.Experience,
    };

    private static Fields? Of(VitalRecord? vital) => vital is not { } m ? null : new Fields
    {
        ["ranks"] = m.Ranks,
        ["start"] = m.Start,
        ["experience"] = m.Experience,
        ["current"] = m.Current,
    };

    private static Fields? Table<T>(ValueList<Property<T>>? table, Func<T, object> value)
    {
        if (table is not { } properties)
            return null;
        var fields = new Fields();
        foreach (Property<T> property in properties)
            fields[property.Id.ToString(System.Globalization.CultureInfo.InvariantCulture)] = value(property.Value);
        return fields;
    }
}
