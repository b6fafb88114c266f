using Spectre.Console;
using Surefoot.Protocol.Session;

namespace Surefoot.Tool.Online;

/// <summary>Where a password comes from: a file, the environment, or whoever sits there. Never the command line, which others can
/// read.</summary>
internal static class PasswordSource
{
    internal const string Variable = "SUREFOOT_PASSWORD";

    /// <summary>A server of the field says something every two seconds: so long a silence is its end, seconds.</summary>
    internal const double Patience = 9;

    /// <summary>Finds the password.</summary>
    /// <param name="file">A file whose first line it is; null for none.</param>
    /// <param name="account">Whose password is asked for.</param>
    /// <exception cref="UsageException">There is none, and nobody to ask. The message holds no password.</exception>
    internal static string Read(FileInfo? file, string account)
    {
        if (file is not null)
        {
            if (!file.Exists) throw new UsageException($"--password-file: there is no file '{file.FullName}'.");
            using StreamReader reader = file.OpenText();
            return reader.ReadLine()
                ?? throw new UsageException($"--password-file: '{file.FullName}' is empty; its first line is the password.");
        }

        if (Environment.GetEnvironmentVariable(Variable) is { Length: > 0 } set) return set;
        if (Console.IsInputRedirected || Console.IsErrorRedirected)
            throw new UsageException($"there is no password and nobody to ask: give --password-file FILE, or set {Variable}.");
        // Asked for on the error stream: the other one is for results.
        IAnsiConsole console = AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Error) });
        return console.Prompt(new TextPrompt<string>($"Password of {Markup.Escape(account)}:").Secret(null).AllowEmpty());
    }

    /// <summary>Who logs in.</summary>
    /// <param name="account">Name of the account.</param>
    /// <param name="passwordFile">A file whose first line is the password; null for none.</param>
    /// <param name="timeout">Seconds that the login may take.</param>
    /// <exception cref="UsageException">One of them cannot be, or there is no password.</exception>
    internal static ClientSessionOptions LogIn(string account, FileInfo? passwordFile, double timeout)
    {
        if (timeout is not (>= 1 and <= 600)) throw new UsageException("--timeout is between 1 and 600 seconds, for example --timeout 30.");
        try
        {
            return new ClientSessionOptions
            {
                Account = account,
                Password = Read(passwordFile, account),
                LoginTimeout = timeout,
                SilenceTimeout = Patience,
            };
        }
        catch (ArgumentException e)
        {
            throw new UsageException(e.Message);
        }
    }
}
