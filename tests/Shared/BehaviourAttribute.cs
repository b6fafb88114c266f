namespace Surefoot.Testing;

/// <summary>Names the observable behaviour that a test pins; <c>docs/behaviours.md</c> is made from these.</summary>
/// <param name="name">Short stable name, e.g. <c>transition.step-up.refuses-above-limit</c>.</param>
/// <param name="source">Where the behaviour comes from: a specification section, with the retail address where there is one.</param>
[AttributeUsage(AttributeTargets.Method, AllowMultiple = true)]
internal sealed class BehaviourAttribute(string name, string source) : Attribute
{
    public string Name { get; } = name;

    public string Source { get; } = source;
}
