namespace Surefoot.Tests;

/// <summary>A sample that a page shows and a test runs: the lines between two marks of the test's source.</summary>
internal static class Sample
{
    private const string Mark = "// sample";

    /// <summary>The page shows what the test ran, usings and all.</summary>
    /// <param name="page">The page.</param>
    /// <param name="heading">A line of the page before the sample.</param>
    /// <param name="test">File name of the test; its own namespace stands for the first using that the page needs.</param>
    internal static void AssertShown(string page, string heading, string test)
    {
        string[] source = File.ReadAllLines(Repository.PathOf("tests", "Surefoot.Tests", test));
        int first = Array.FindIndex(source, line => line.Trim() == Mark), last = Array.FindLastIndex(source, line => line.Trim() == Mark);
        IEnumerable<string> usings = source.TakeWhile(line => line.StartsWith("using ", StringComparison.Ordinal))
            .Append("using Surefoot;")
            .OrderBy(line => !line.StartsWith("using System", StringComparison.Ordinal))
            .ThenBy(line => line.TrimEnd(';'), StringComparer.Ordinal);
        string[] sample = [.. usings.Concat(source[(first + 1)..last]).Select(line => line.Trim()).Where(line => line.Length > 0)];

        string[] text = File.ReadAllLines(Repository.PathOf(page.Split('/')));
        int begin = Array.IndexOf(text, "```csharp", Array.IndexOf(text, heading)) + 1;
        string[] shown = [.. text[begin..Array.IndexOf(text, "```", begin)].Select(line => line.Trim()).Where(line => line.Length > 0)];
        Assert.Equal(sample, shown);
    }
}
