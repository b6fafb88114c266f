using System.Text.RegularExpressions;

namespace Surefoot.Tool.Tests.Packages;

/// <summary>What the README shows.</summary>
internal static class ReadmeText
{
    /// <summary>The folder that its sample of a configuration names.</summary>
    internal const string FeedExample = "/path/to/surefoot/artifacts";

    /// <summary>The README.</summary>
    internal static string Whole { get; } = File.ReadAllText(Repository.PathOf("README.md")).ReplaceLineEndings("\n");

    /// <summary>Its only block in a language, word for word.</summary>
    internal static string Block(string language) =>
        Assert.Single(Regex.Matches(Whole, $"```{language}\n(.*?)```", RegexOptions.Singleline)).Groups[1].Value;
}
