using Spectre.Console;

namespace Surefoot.Tool.Output;

/// <summary>A progress bar where a person looks on; nothing where a program does.</summary>
internal static class ProgressBar
{
    /// <summary>Runs work with a result that reports how many of how many it has done.</summary>
    /// <param name="name">What is counted.</param>
    /// <param name="quiet">Never draw.</param>
    /// <param name="work">The work.</param>
    internal static T Run<T>(string name, bool quiet, Func<Action<int, int>, T> work)
    {
        T result = default!;
        Run(name, quiet, report => { result = work(report); });
        return result;
    }

    /// <summary>Runs work that reports how many of how many it has done.</summary>
    /// <param name="name">What is counted.</param>
    /// <param name="quiet">Never draw.</param>
    /// <param name="work">The work.</param>
    internal static void Run(string name, bool quiet, Action<Action<int, int>> work)
    {
        if (quiet || !AnsiConsole.Profile.Capabilities.Interactive)
        {
            work((_, _) => { });
            return;
        }

        AnsiConsole.Progress().AutoClear(true).Start(progress =>
        {
            ProgressTask task = progress.AddTask(name);
            work((done, total) =>
            {
                task.MaxValue = total;
                task.Value = done;
            });
        });
    }
}
