using System.Reflection;
using ArchLoader = ArchUnitNET.Loader.ArchLoader;

namespace Surefoot.Tool.Tests.Docs;

/// <summary>Who uses whom in an assembly, type by type, as its metadata and the bodies of its methods say.</summary>
internal static class LayerReader
{
    private const BindingFlags Everything =
        BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;

    /// <summary>One type uses another one of another layer.</summary>
    /// <param name="From">Layer of the user; empty for the root namespace.</param>
    /// <param name="User">Name of the user; of a lambda, an iterator or a nested type the type around it.</param>
    /// <param name="To">Layer of what is used.</param>
    /// <param name="Used">Its name.</param>
    internal readonly record struct Use(string From, string User, string To, string Used)
    {
        public override string ToString() => $"{From}.{User} -> {To}.{Used}";
    }

    /// <summary>All uses across the layers of an assembly, each once. A layer is a namespace right below a root.</summary>
    internal static Use[] Read(Assembly assembly, string root) =>
    [
        .. Dependencies(assembly).Concat(Catches(assembly))
            .Where(pair => IsBelow(pair.User, root) && IsBelow(pair.Used, root))
            .Select(pair => new Use(LayerOf(pair.User, root), NameOf(pair.User), LayerOf(pair.Used, root), NameOf(pair.Used)))
            .Where(use => use.From != use.To)
            .Distinct()
            .OrderBy(use => use.ToString(), StringComparer.Ordinal),
    ];

    /// <summary>The layers that have a type.</summary>
    internal static string[] Layers(Assembly assembly, string root) =>
        [.. assembly.GetTypes().Select(Of).Where(name => IsBelow(name, root)).Select(name => LayerOf(name, root)).Distinct()];

    private static IEnumerable<(TypeName User, TypeName Used)> Dependencies(Assembly assembly) =>
        new ArchLoader()
            .LoadAssembly(assembly)
            .Build().Types.SelectMany(user => user.Dependencies, (user, dependency) => (Of(user), Of(dependency.Target)));

    /// <summary>What is caught, which the library does not tell.</summary>
    private static IEnumerable<(TypeName User, TypeName Used)> Catches(Assembly assembly) =>
        from user in assembly.GetTypes()
        from method in user.GetMethods(Everything).Cast<MethodBase>().Concat(user.GetConstructors(Everything))
        from clause in method.GetMethodBody()?.ExceptionHandlingClauses ?? []
        where clause.Flags == ExceptionHandlingClauseOptions.Clause
        select (Of(user), Of(clause.CatchType!));

    private static TypeName Of(ArchUnitNET.Domain.IType type) => new(type.Namespace?.FullName ?? "", type.FullName);

    private static TypeName Of(Type type) => new(type.Namespace ?? "", type.FullName ?? type.Name);

    private static bool IsBelow(TypeName type, string root) => $"{type.Space}.".StartsWith($"{root}.", StringComparison.Ordinal);

    private static string LayerOf(TypeName type, string root) =>
        type.Space.Length == root.Length ? "" : type.Space[(root.Length + 1)..].Split('.')[0];

    private static string NameOf(TypeName type) => type.Name[(type.Space.Length + 1)..].Split('+', '`')[0];

    private readonly record struct TypeName(string Space, string Name);
}
