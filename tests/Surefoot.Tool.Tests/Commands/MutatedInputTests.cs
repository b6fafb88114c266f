using Surefoot.DemoWorld;
using Surefoot.Tool.Conformance;
using Surefoot.Tool.Tests.Sniffing;

namespace Surefoot.Tool.Tests.Commands;

/// <summary>Every command, given wrong words and damaged files: a sentence and an exit code, never a stack trace.</summary>
[Collection(ConsoleCollection.Name)]
public sealed class MutatedInputTests : IDisposable
{
    private static readonly int Inputs = Fuzz.Cases(500);
    private readonly DirectoryInfo folder = Directory.CreateTempSubdirectory("surefoot-mutated");
    private readonly string before = Environment.CurrentDirectory;

    // Words in the place of a folder's name are folders here.
    public MutatedInputTests() => Environment.CurrentDirectory = folder.FullName;

    public void Dispose()
    {
        Environment.CurrentDirectory = before;
        folder.Delete(recursive: true);
    }

    [Theory, Behaviour("tool.input.never-a-stack-trace", "design.md, decision 7")]
    [InlineData("walk")]
    [InlineData("play")]
    [InlineData("dats list")]
    [InlineData("dats show")]
    [InlineData("dats verify")]
    [InlineData("demo write")]
    [InlineData("demo map")]
    [InlineData("demo places")]
    [InlineData("demo arrows")]
    [InlineData("demo rows")]
    [InlineData("sniff")]
    [InlineData("network")]
    [InlineData("authority")]
    [InlineData("serve")]
    [InlineData("conform")]
    public async Task Damaged_files_and_wrong_words_end_in_a_sentence(string command)
    {
        Mutations mutations = new(command, folder);
        int inputs = command == "serve" ? Inputs / 5 : Inputs;
        for (int i = 0; i < inputs; i++)
        {
            string[] arguments = mutations.Next(i);
            string shown = $"input {i}: surefoot {string.Join(' ', arguments)}";
            CommandLine.Outcome run = default!;
            Exception? thrown = await Record.ExceptionAsync(async () => run = await InProcess.RunAsync(arguments));
            Assert.True(thrown is null, $"{shown}\n{thrown}");
            Assert.True(run.ExitCode is >= 0 and <= 2, shown);
            Assert.False(run.Error.Contains(Program.Unexpected, StringComparison.Ordinal), $"{shown}\n{run.Error}");
            if (run.ExitCode == 2) Assert.True(run.Error.Length > 0, shown);
        }
    }
}

/// <summary>Command lines that are nearly right, over files that are nearly right; the same for the same numbers.</summary>
internal sealed class Mutations
{
    private static readonly string[] Words =
    [
        "", " ", "--", "-1", "0", "1e30", "NaN", "99999999999", "0x", "0xA9B4FFFF,1,1,1", "0xFFFFFFFF,0,0,0", "0x01050100,0,0,0",
        "0xA9B40001,1e9,12,0", "0xA9B40001,NaN,0,0",
        "0xA9B40001,,,", "meadow", "dungeon", "W", "W 1;", "W+ 1", ";;", "W -1", "W 1e400", "Space 0.1", "Ünïcode", "[red]", "{0}", "%s",
        "/dev/null", "--help", "--json",
    ];

    private const string Likeliest = "0123456789.-eE,:\"[]{}ABCDEF";

    private readonly string command;
    private readonly DirectoryInfo folder;
    private readonly string world;
    private readonly (string Path, byte[] Bytes)[] sources;

    internal Mutations(string command, DirectoryInfo folder)
    {
        this.command = command;
        this.folder = folder;
        world = Path.Combine(folder.FullName, "world");
        if (command == "conform")
        {
            Directory.CreateDirectory(world);
            foreach (string path in VectorFiles()) CopyFirstCase(path);
        }
        else if (command == "sniff")
        {
            Directory.CreateDirectory(world);
            foreach (bool blocks in (bool[])[false, true])
            {
                CaptureForm form = new(blocks, Swapped: blocks, LinkType: 1, Nanoseconds: false);
                File.WriteAllBytes(Path.Combine(world, $"{blocks}.pcap"), CaptureWriter.Write(form, CaptureWriter.Recorded("enter"), 1e9));
            }
        }
        else
        {
            DemoWorldBuilder.Write(world);
        }

        sources = [.. Directory.GetFiles(world).Order(StringComparer.Ordinal).Select(path => (path, File.ReadAllBytes(path)))];
    }

    /// <summary>The next command line; the files it reads are damaged now.</summary>
    internal string[] Next(int index)
    {
        Random random = new(index);
        if (random.Next(3) > 0) Damage(random);
        List<string> words = [.. command.Split(' '), .. Arguments(random)];
        // Every second command line is wrong in a word.
        if (random.Next(2) == 0)
        {
            int at = random.Next(1, words.Count + 1);
            string word = Words[random.Next(Words.Length)];
            switch (random.Next(3))
            {
                case 0: words.Insert(at, word); break;
                case 1 when at < words.Count: words[at] = word; break;
                default: words.RemoveAt(Math.Min(at, words.Count - 1)); break;
            }
        }

        if (command == "play") words.AddRange(["--no-browser", "--port", "0"]);
        if (command == "serve") words.AddRange(["--port", "0", "--quiet"]);
        return [.. words];
    }

    private string[] Arguments(Random random) => command switch
    {
        "walk" =>
            [
                "--script", random.Next(2) == 0 ? "W 0.2" : "W+Space 0.1; Wait 0.1", "--at", Place(random), "--dats", world, "--run",
                $"{random.Next(900)}", .. random.Next(3) == 0 ? ["--csv", "--quantum", $"{random.Next(200)}"] : Array.Empty<string>()],
        "play" => ["--dats", world],
        "serve" => ["--dats", world, "--slots", $"{random.Next(300)}", "--run", $"{random.Next(900)}"],
        "dats list" => random.Next(2) == 0 ? [world] : [world, "--type", "Setup"],
        "dats show" => [world, $"{(uint)random.NextInt64(uint.MaxValue):X8}"],
        "dats verify" => [world, "--json"],
        "demo write" => [Path.Combine(folder.FullName, "out"), "--seed", $"{random.Next(3)}"],
        "demo map" => [Path.Combine(folder.FullName, "map.svg")],
        "demo places" => ["--json"],
        "demo arrows" => ["--seconds", "0.1"],
        "demo rows" => [Path.Combine(folder.FullName, "rows.sql"), "--seed", $"{random.Next(3)}"],
        "sniff" =>
            [
                sources[random.Next(sources.Length)].Path, .. random.Next(2) == 0 ? ["--port", "9300"] : Array.Empty<string>(),
                .. random.Next(2) == 0 ? ["--json", "--packets", "--bytes"] : Array.Empty<string>()],
        "network" => ["--minutes", "0.1", "--seed", $"{random.Next(3)}", "--loss", $"{random.Next(101)}", "--delay", $"{random.Next(999)}"],
        // A good line takes seconds, for all cheats are tried: AuthorityTests runs one.
        "authority" => ["--hours", random.Next(2) == 0 ? "0" : "1e9", "--seed", $"{random.Next(3)}"],
        _ => Recording(random),
    };

    private string[] Recording(Random random)
    {
        string file = sources[random.Next(sources.Length)].Path;
        string dats = Path.GetFileName(file).StartsWith("walk-1", StringComparison.Ordinal) ? "first" : "oracle";
        string recordings = random.Next(20) == 0 ? world : file;
        return ["--dats", Repository.PathOf("tests", "data", "worlds", dats), recordings, "--require", $"{random.Next(101)}"];
    }

    private static string Place(Random random) => random.Next(3) switch
    {
        0 => $"0xA9B500{random.Next(1, 65):X2},{random.Next(192)},{random.Next(192)},{random.Next(100)}",
        1 => $"0x{random.Next(256):X2}{random.Next(256):X2}{random.Next(65536):X4},12,12,0",
        _ => "0xA9B50032,150,30,20,90",
    };

    private void Damage(Random random)
    {
        (string path, byte[] whole) = sources[random.Next(sources.Length)];
        foreach ((string other, byte[] bytes) in sources) if (other != path) File.WriteAllBytes(other, bytes);
        byte[] damaged = (byte[])whole.Clone();
        bool isText = command == "conform";
        for (int i = random.Next(1, isText ? 6 : 30); i > 0 && damaged.Length > 0; i--)
            damaged[random.Next(damaged.Length)] = isText ? Likely(random) : (byte)random.Next(256);
        if (random.Next(8) == 0) damaged = damaged[..random.Next(damaged.Length)];
        File.WriteAllBytes(path, damaged);
    }

    /// <summary>A byte that a recording may well have, so that damage often leaves it readable.</summary>
    private static byte Likely(Random random) => (byte)(random.Next(4) == 0 ? random.Next(128) : Likeliest[random.Next(Likeliest.Length)]);

    /// <summary>Cases of one file for each kind of recording; whole sessions as they are.</summary>
    private static IEnumerable<string> VectorFiles() =>
        new[] { "vectors", "oracle-vectors", "remote-vectors" }
            .SelectMany(set => Directory.GetFiles(Repository.PathOf("tests", "data", set), "*.jsonl.gz"))
            .Append(Repository.PathOf("tests", "data", "wire-captures", "names.jsonl.gz")).Order(StringComparer.Ordinal);

    private void CopyFirstCase(string path)
    {
        string name = Path.GetFileName(path)[..^".gz".Length];
        using VectorFile file = VectorFile.Open(path);
        bool isSession = VectorKinds.Of(file) == VectorKind.Captures;
        File.WriteAllLines(Path.Combine(world, name), file.Read(line => line).Take(isSession ? int.MaxValue : 1));
        if (!isSession) return;
        string expected = Path.ChangeExtension(name, ".expected.json");
        using FileStream found = File.OpenRead(Path.Combine(Path.GetDirectoryName(path)!, expected + ".gz"));
        using StreamReader reader = VectorFile.Unpack(found, found.Name);
        File.WriteAllText(Path.Combine(world, expected), reader.ReadToEnd());
    }
}
