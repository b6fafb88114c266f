// Each type hides one use of an upper layer, each in another way: LayerReader must see them all. Nothing here is ever run.
#pragma warning disable CA1812, CA1822, CA1823, CA1852, CA1805, CS0067, CS0169, IDE0044, IDE0051, CS0414, CA1814, IDE0052
using Surefoot.Tool.Tests.Planted.Above;

namespace Surefoot.Tool.Tests.Planted.Below;

[UsedAsAttribute]
internal class Attribute;

internal class BaseType : Used;

internal class Interface : IUsedAsInterface;

internal class Field
{
    private Used? field;
}

internal class Parameter
{
    internal void Take(Used used)
    {
    }
}

internal class Returned
{
    internal Used? Give() => null;
}

internal class GenericArgument
{
    internal int Count() => new List<Used>().Count;
}

internal class Local
{
    internal bool Ask(object given)
    {
        Used? local = (Used?)given;
        return local is null;
    }
}

internal class Constructed
{
    internal object Make() => new Used();
}

internal class StaticCall
{
    internal int Ask() => Used.Number;
}

internal class Tested
{
    internal bool Ask(object given) => given is Used;
}

internal class TypeOf
{
    internal string Name() => typeof(Used).Name;
}

internal class Caught
{
    internal void Try(Action action)
    {
        try
        {
            action();
        }
        catch (UsedAsError)
        {
        }
    }
}

internal class InLambda
{
    internal Func<int> Give(int add) => () => Used.Number + add;
}

internal class InLocalFunction
{
    internal int Ask(int add)
    {
        return Number();
        int Number() => Used.Number + add;
    }
}

internal class InNestedType
{
    private class Nested
    {
        internal int Ask() => Used.Number;
    }
}

internal class OfExtension
{
    internal int Ask() => 1.Twice();
}

internal class NewArray
{
    internal Array Make() => new Used[3];
}

internal class Constraint<T>
    where T : Used
{
}

internal class MethodConstraint
{
    internal void Ask<T>()
        where T : Used
    {
    }
}

internal class GenericMethodArgument
{
    internal int Count() => Array.Empty<Used>().Length;
}

internal class NestedGenericArgument
{
    private Dictionary<int, List<Used>>? fields;
}

internal class DelegateField
{
    private Func<int, Used>? make;
}

internal class Property
{
    internal Used? Value { get; set; }
}

internal class Event
{
    internal event EventHandler<Used>? Changed;

    internal void Raise() => Changed?.Invoke(this, new());
}

internal class MethodAttribute
{
    [UsedAsAttribute]
    internal void Do()
    {
    }
}

[System.ComponentModel.TypeConverter(typeof(Used))]
internal class AttributeArgument;

internal class OutParameter
{
    internal void Give(out Used? used) => used = null;
}

internal class DefaultValue
{
    internal string? Ask() => default(UsedAsStruct).ToString();
}

internal class LocalArray
{
    internal int Ask()
    {
        UsedAsStruct[] all = new UsedAsStruct[2];
        return all.Length;
    }
}

internal class InIterator
{
    internal IEnumerable<int> Give()
    {
        yield return Used.Number;
    }
}

internal class InAsync
{
    internal async Task<int> Give()
    {
        await Task.Yield();
        return Used.Number;
    }
}

internal class StaticLambda
{
    private static readonly Func<int> Ask = static () => Used.Number;
}

internal class AutoInitializer
{
    private int number = Used.Number;
}
