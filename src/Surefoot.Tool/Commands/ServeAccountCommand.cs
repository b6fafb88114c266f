using System.CommandLine;
using Surefoot.Server;
using Surefoot.Tool.Online;

namespace Surefoot.Tool.Commands;

/// <summary><c>surefoot serve account</c>: writes the file of accounts.</summary>
internal static class ServeAccountCommand
{
    internal static Command Create()
    {
        Option<string> accounts = new("--accounts") { Description = "The file; made when missing.", Required = true };
        Option<string> name = new("--account") { Description = "Name of the account.", Required = true };
        Option<bool> administrator = new("--admin") { Description = "It may give commands by chat." };
        Option<FileInfo?> passwordFile = new("--password-file") { Description = "File whose first line is the password." };
        Command command = new("account",
            "Puts an account into a file of accounts, or gives it another password. The password comes from --password-file, the " +
            $"environment variable {PasswordSource.Variable}, or is asked for; the file keeps a salted hash of it.\n\n" +
            "Example:\n  surefoot serve account --accounts accounts.json --account anna --admin")
        {
            accounts, name, administrator, passwordFile,
        };
        command.SetAction(parsed =>
        {
            AccountFile file = AccountFile.ReadOrBegin(parsed.GetRequiredValue(accounts));
            string account = parsed.GetRequiredValue(name), password = PasswordSource.Read(parsed.GetValue(passwordFile), account);
            try
            {
                file.Set(account, password, parsed.GetValue(administrator));
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
}
