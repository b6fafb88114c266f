using System.Collections.Concurrent;

namespace Surefoot.Server;

/// <summary>Checks logins: quick ones at once, slow ones one after the other on a thread of its own.</summary>
internal sealed class PasswordChecks : IDisposable
{
    private const int MostWaiting = 256;

    private readonly IAccounts accounts;
    private readonly BlockingCollection<Work>? waiting;
    private readonly ConcurrentQueue<Work> done = new();
    private readonly Thread? worker;

    public PasswordChecks(IAccounts accounts)
    {
        this.accounts = accounts;
        if (!accounts.IsSlow) return;
        waiting = new BlockingCollection<Work>(MostWaiting);
        worker = new Thread(Run) { IsBackground = true, Name = "Surefoot passwords" };
        worker.Start();
    }

    /// <summary>Begins a check.</summary>
    /// <returns>False when too many wait already.</returns>
    public bool TryBegin(ClientConnection client, string account, string password)
    {
        Work work = new(client, account, password);
        if (waiting is not null) return waiting.TryAdd(work);
        done.Enqueue(work with { Verdict = accounts.Check(account, password) });
        return true;
    }

    /// <summary>Takes the result of a check that is over.</summary>
    public bool TryTake(out ClientConnection client, out AccountVerdict verdict)
    {
        bool isDone = done.TryDequeue(out Work? work);
        (client, verdict) = isDone ? (work!.Client, work.Verdict) : (null!, default);
        return isDone;
    }

    public void Dispose()
    {
        if (waiting is null) return;
        waiting.CompleteAdding();
        worker!.Join();
        waiting.Dispose();
    }

    private void Run()
    {
        foreach (Work work in waiting!.GetConsumingEnumerable())
        {
            if (waiting.IsAddingCompleted) return;
            done.Enqueue(work with { Verdict = accounts.Check(work.Account, work.Password), Password = "" });
        }
    }

    private sealed record Work(ClientConnection Client, string Account, string Password)
    {
        public AccountVerdict Verdict { get; init; }

        public override string ToString() => Account;
    }
}
