namespace Surefoot.Tool.Tests.Packages;

/// <summary>The README, read from the beginning.</summary>
public class ReadmeTests
{
    [Fact, Behaviour("docs.readme.install-first", "README, Install")]
    public void The_readme_says_how_to_install_the_command_before_it_first_uses_its_name()
    {
        const string Install = "dotnet tool install --global Surefoot.Tool --add-source artifacts";
        int install = ReadmeText.Whole.IndexOf(Install, StringComparison.Ordinal);
        Assert.True(install > 0);
        Assert.DoesNotContain("surefoot", ReadmeText.Whole[..install], StringComparison.Ordinal);
        Assert.Contains("./pack", ReadmeText.Whole[..install], StringComparison.Ordinal);
    }
}
