using System.CommandLine;
using Spectre.Console;
using Surefoot.Server;

namespace Surefoot.Tool.Commands;

/// <summary><c>surefoot serve account</c>: writes the file of accounts.</summary>
internal static class ServeAccountCommand
{
    /// <summary>Environment variable with the password, for those who cannot be asked.</summary>
    private const string PasswordVariable = "SUREFOOT_PASSWORD";

    internal static Command Create()
    {
        Option<string> accounts = new("--accounts") { Description = "The file; made when missing.", Required = true };
        Option<string> name = new("--account") { Description = "Name of the account.", Required = true };
        Option<bool> administrator = new("--admin") { Description = "It may give commands by chat." };
        Option<FileInfo?> passwordFile = new("--password-file") { Description = "File whose first line is the password." };
        Command command = new("account",
            "Puts an account into a file of accounts, or gives it another password. The password comes from --password-file, the " +
            $"environment variable {PasswordVariable}, or is asked for; the file keeps a salted hash of it.\n\n" +
            "Example:\n  surefoot serve account --accounts accounts.json --account anna --admin")
        {
            accounts, name, administrator, passwordFile,
        };
        command.SetAction(parsed =>
        {
            AccountFile file = AccountFile.ReadOrBegin(parsed.GetRequiredValue(accounts));
            try
            {
                file.Set(parsed.GetRequiredValue(name), PasswordFrom(parsed.GetValue(passwordFile)), parsed.GetValue(administrator));
            }
            catch (ArgumentException error)
            {
                throw new UsageException(error.Message.Split(" (Parameter")[0]);
            }

            Console.Out.WriteLine($"{file.Count} accounts in {parsed.GetRequiredValue(accounts)}");
            return ExitCode.Done;
        });
        return command;
    }

    private static string PasswordFrom(FileInfo? file)
    {
        if (file is not null) return File.ReadLines(file.FullName).FirstOrDefault() ?? "";
        if (Environment.GetEnvironmentVariable(PasswordVariable) is { Length: > 0 } password) return password;
        if (!AnsiConsole.Profile.Capabilities.Interactive || Console.IsInputRedirected)
            throw new UsageException($"There is nobody to ask for the password: use --password-file FILE or {PasswordVariable}.");
        return AnsiConsole.Prompt(new TextPrompt<string>("Password:").Secret());
    }
}
