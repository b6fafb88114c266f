// What the types of Below.cs use.
namespace Surefoot.Tool.Tests.Planted.Above;

internal class Used
{
    internal static int Number { get; set; }
}

internal interface IUsedAsInterface;

internal sealed class UsedAsError : Exception;

[AttributeUsage(AttributeTargets.All)]
internal sealed class UsedAsAttributeAttribute : Attribute;

internal struct UsedAsStruct;

internal static class UsedAsExtension
{
    internal static int Twice(this int number) => 2 * number;
}
