using System.Security.Cryptography;
using Surefoot.Protocol.Messages;
using Surefoot.Protocol.Session;

namespace Surefoot.Server;

/// <summary>The sessions of a server: whose a datagram is, who may begin one, and when one is over.</summary>
/// <remarks>Specification 08, 8.1 and 8.2.</remarks>
internal sealed class ClientTable : IDisposable
{
    private const uint InUse = 1, BadAccount = 9, Unknown = 0x0A, Full = 0x15, Closing = 4;

    /// <summary>Refusals a second for which no session is made, of all addresses together.</summary>
    private const double RefusalsPerSecond = 50;

    /// <summary>A little less than a frame of sixty a second, so that a caller's loop of that rate sends in every frame.</summary>
    private const double SendInterval = 0.016;

    private readonly WorldServer server;
    private readonly IServerTransport transport;
    private readonly ClientConnection?[] slots;
    private readonly Dictionary<ClientAddress, ClientConnection> byAddress = [];
    private readonly LoginGate gate;
    private readonly PasswordChecks checks;
    private double refusalsPaid;
    private int nextSender = -1;

    public ClientTable(WorldServer server, IServerTransport transport, IAccounts accounts)
    {
        this.server = server;
        this.transport = transport;
        slots = new ClientConnection?[server.Options.Slots];
        gate = new LoginGate(server.Options.LoginsPerSecond);
        checks = new PasswordChecks(accounts);
    }

    /// <summary>Sessions that there are.</summary>
    public int Count => byAddress.Count;

    /// <summary>Every session.</summary>
    public Dictionary<ClientAddress, ClientConnection>.ValueCollection All => byAddress.Values;

    /// <summary>Takes a datagram.</summary>
    public void Receive(ReadOnlySpan<byte> datagram, ClientAddress from, ServerPort port)
    {
        if (port == ServerPort.Second) ReceiveAtSecond(datagram, from);
        else if (byAddress.TryGetValue(from, out ClientConnection? client)) ReceiveAtFirst(client, datagram);
        else if (ServerLink.TryReadLogin(datagram) is { } login) Begin(login, datagram.Length, from);
        else server.Figures.ForeignDatagrams++;
    }

    /// <summary>Checks that are over; then sessions do what time asks for, and send what they have: each at most sixty times a
    /// second.</summary>
    /// <param name="most">How many of them; the others are next.</param>
    public void Update(int most)
    {
        while (checks.TryTake(out ClientConnection client, out AccountVerdict verdict)) Judge(client, verdict);
        for (int i = 0; i < slots.Length && most > 0; i++)
        {
            if (++nextSender >= slots.Length) nextSender = 0;
            if (slots[nextSender] is not { } client || server.Now < client.SendsAt) continue;
            most--;
            client.SendsAt = server.Now + SendInterval;
            server.Lobby.Update(client);
            client.Link.Update(server.Now);
            if (client.Link.State == ServerLinkState.Ended) End(client);
        }
    }

    /// <summary>Ends all sessions: their clients are told.</summary>
    public void Close()
    {
        foreach (ClientConnection? client in slots)
        {
            if (client is null) continue;
            if (client.IsAlive) client.Link.Refuse(new CharacterError(Closing), server.Now);
            client.Link.Update(server.Now);
        }
    }

    public void Dispose() => checks.Dispose();

    private void ReceiveAtSecond(ReadOnlySpan<byte> datagram, ClientAddress from)
    {
        if (byAddress.TryGetValue(from, out ClientConnection? own))
        {
            if (own.TryConnect(datagram, from)) server.Lobby.Welcome(own);
            return;
        }

        // From another port of the same machine: the cookie tells whose it is.
        foreach (ClientConnection? client in slots)
        {
            if (client is null || !client.TryConnect(datagram, from)) continue;
            server.Lobby.Welcome(client);
            return;
        }

        server.Figures.ForeignDatagrams++;
    }

    private void ReceiveAtFirst(ClientConnection client, ReadOnlySpan<byte> datagram)
    {
        // The answer to its login may have been lost. (Servers of the field end the session then.)
        if (client.IsHalfOpen && ServerLink.TryReadLogin(datagram) is not null) client.Link.Repeat(datagram.Length, server.Now);
        else client.Link.Receive(datagram, ServerPort.First, server.Now, client);
    }

    private void Begin(LoginRequest login, int length, ClientAddress from)
    {
        if (!gate.TryPass(from, server.Now))
        {
            server.Figures.LoginsOverRate++;
            return;
        }

        if (login.Version != LoginRequest.LiveVersion)
        {
            server.Figures.Refuse(LoginRefusal.Version);
            byte[] refusal = ServerLink.WriteRefusalOfVersion(
                new AccountBoot($" this server speaks to version {LoginRequest.LiveVersion} alone"), server.Now, Random32());
            if (IsRefusalPaid() && refusal.Length <= 3 * length) transport.Send(refusal, ServerPort.First, from);
            return;
        }

        if (!TryFindSlot(from, out int slot))
        {
            server.Figures.Refuse(LoginRefusal.Full);
            if (IsRefusalPaid()) RefuseOnce(length, from);
            return;
        }

        ClientConnection client = new(server, transport, NumbersOf(slot), length, from);
        slots[slot] = client;
        byAddress.Add(from, client);
        server.Figures.Logins++;
        string account = AccountFile.Key(login.Account);
        if (login.AuthType != LoginRequest.PasswordAuth || !AccountFile.IsName(account)) Refuse(client, LoginRefusal.Account, BadAccount);
        else if (!checks.TryBegin(client, account, login.Password)) Refuse(client, LoginRefusal.Full, Closing);
        else client.Account = account;
    }

    private void Judge(ClientConnection client, AccountVerdict verdict)
    {
        if (client.Link.State != ServerLinkState.Verifying) return;
        switch (verdict)
        {
            case AccountVerdict.Unknown:
                Refuse(client, LoginRefusal.Account, Unknown);
                break;
            case AccountVerdict.WrongPassword:
                server.Figures.Refuse(LoginRefusal.Password);
                server.Say($"wrong password for the account {client.Account} from {client.Address}");
                client.Account = "";
                client.Link.Refuse(new AccountBoot(" the password is another one"), server.Now);
                break;
            default:
                Admit(client, verdict == AccountVerdict.Administrator);
                break;
        }
    }

    private void Admit(ClientConnection client, bool administrator)
    {
        bool isInUse = false;
        foreach (ClientConnection? other in slots)
        {
            // One that ends still has its account: for two seconds anew (specification 08, 3.6).
            if (other is null || other == client || other.Account != client.Account || other.Link.State == ServerLinkState.Verifying)
                continue;
            isInUse = true;
            if (other.IsAlive) other.Link.Refuse(new CharacterError(InUse), server.Now);
        }

        if (isInUse)
        {
            Refuse(client, LoginRefusal.InUse, InUse);
            return;
        }

        client.IsAdministrator = administrator;
        client.Link.Admit();
    }

    private void Refuse(ClientConnection client, LoginRefusal reason, uint code)
    {
        server.Figures.Refuse(reason);
        server.Say($"login refused ({reason}) from {client.Address}");
        client.Link.Refuse(new CharacterError(code), server.Now);
    }

    private void End(ClientConnection client)
    {
        client.Player?.LeaveAtOnce();
        slots[client.Slot] = null;
        byAddress.Remove(client.Address);
        server.Figures.Add(client.Link.Statistics);
    }

    /// <summary>The lowest free slot. When there is none, the oldest stranger's: who has not answered gives way.</summary>
    private bool TryFindSlot(ClientAddress from, out int slot)
    {
        (slot, int fromThere) = (-1, 0);
        ClientConnection? oldest = null;
        for (int i = slots.Length - 1; i >= 0; i--)
        {
            if (slots[i] is not { } client)
            {
                slot = i;
                continue;
            }

            if (client.Address.Network == from.Network) fromThere++;
            if (!client.HasAnswered && (oldest is null || client.Number < oldest.Number)) oldest = client;
        }

        if (server.Options.MostPerAddress > 0 && fromThere >= server.Options.MostPerAddress) return false;
        if (oldest is null || slot >= 0) return slot >= 0;
        slot = oldest.Slot;
        End(oldest);
        return true;
    }

    private void RefuseOnce(int loginLength, ClientAddress from)
    {
        Once sink = new(transport, from);
        ServerLink link = new(NumbersOf(0), loginLength, sink, server.Now);
        link.Refuse(new CharacterError(Full), server.Now);
        link.Update(server.Now);
    }

    private bool IsRefusalPaid()
    {
        double paid = Math.Max(refusalsPaid, server.Now) + (1 / RefusalsPerSecond);
        if (paid > server.Now + 1) return false;
        refusalsPaid = paid;
        return true;
    }

    private static ServerLinkOptions NumbersOf(int slot) =>
        new((ushort)slot, ((ulong)Random32() << 32) | Random32(), Random32(), Random32());

    private static uint Random32()
    {
        Span<byte> bytes = stackalloc byte[4];
        RandomNumberGenerator.Fill(bytes);
        return BitConverter.ToUInt32(bytes);
    }

    private sealed class Once(IServerTransport transport, ClientAddress to) : IDatagramSink
    {
        public void Send(ReadOnlySpan<byte> datagram, ServerPort port) => transport.Send(datagram, port, to);
    }
}
