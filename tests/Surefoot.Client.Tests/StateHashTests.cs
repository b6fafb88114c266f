using System.Runtime.InteropServices;
using System.Text;
using Surefoot.Dats;
using Surefoot.DemoWorld;
using Surefoot.Scenes;

namespace Surefoot.Client.Tests;

/// <summary>
/// Pins the bits that come of the scenes: whoever rearranges the house sees that nothing moved, and whoever means to change a result says
/// so by renewing the record.
/// </summary>
public sealed class StateHashTests
{
    private const string Renew = "SUREFOOT_UPDATE_HASHES";

    [Fact]
    [Behaviour("properties.state-hashes.pinned", "design.md, decision 5")]
    public void The_scenes_end_in_the_states_on_record()
    {
        // Powers and sines come from the platform's library and may differ in the last bit elsewhere.
        Assert.SkipUnless(OperatingSystem.IsLinux() && RuntimeInformation.ProcessArchitecture == Architecture.X64,
            "the record is of Linux on x64");
        StringBuilder hashes = new();
        using (DatSet dats = DatSet.Open(DemoWorldCache.GetOrCreate()))
        {
            foreach (Scene scene in Scene.All) hashes.Append($"{scene.Hash(dats):x16}  {scene.Name}\n");
        }

        string path = Repository.PathOf("tests", "data", "state-hashes.txt");
        if (Environment.GetEnvironmentVariable(Renew) == "1") File.WriteAllText(path, hashes.ToString());
        string record = File.Exists(path) ? File.ReadAllText(path).ReplaceLineEndings("\n") : "";
        Assert.True(
            record == hashes.ToString(),
            $"""
            Some body in a scene is no longer, bit for bit, where it was. Now:
            {hashes}On record in tests/data/state-hashes.txt:
            {record}A change that should not alter any result has altered one. If it was meant to, run this test once with {Renew}=1,
            commit the file, and say in the commit which behaviour changed and why.
            """);
    }
}
