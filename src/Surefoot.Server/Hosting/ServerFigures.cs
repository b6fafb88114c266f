using Surefoot.Protocol.Session;

namespace Surefoot.Server;

/// <summary>Why a login was refused.</summary>
public enum LoginRefusal
{
    /// <summary>Another version of the client.</summary>
    Version,

    /// <summary>No account has that name, or it cannot be one.</summary>
    Account,

    /// <summary>The password is another one.</summary>
    Password,

    /// <summary>The account is in use.</summary>
    InUse,

    /// <summary>There is no slot, or the address has as many as it may.</summary>
    Full,
}

/// <summary>What a server counts while it runs. Numbers are written by the server's thread alone and may be read by any.</summary>
public sealed class ServerFigures
{
    private readonly long[] refusedLogins = new long[Enum.GetValues<LoginRefusal>().Length];
    private readonly long[] refusedClaims = new long[Enum.GetValues<ClaimReason>().Length];
    private readonly long[] dropped = new long[Enum.GetValues<DropReason>().Length];
    private readonly long[] endedDrops = new long[Enum.GetValues<DropReason>().Length];
    private readonly long[] sumDrops = new long[Enum.GetValues<DropReason>().Length];
    private readonly SessionTotals ended = new(), sum = new();

    /// <summary>How long passes took.</summary>
    public StepTimes Steps { get; } = new();

    /// <summary>Sessions at the moment.</summary>
    public int Sessions { get; internal set; }

    /// <summary>Players in the world at the moment.</summary>
    public int Players { get; internal set; }

    /// <summary>Objects in the world at the moment, players among them.</summary>
    public int Objects { get; internal set; }

    /// <summary>Logins that began a session.</summary>
    public long Logins { get; internal set; }

    /// <summary>Logins not looked at because too many came from one address.</summary>
    public long LoginsOverRate { get; internal set; }

    /// <summary>Characters that entered the world.</summary>
    public long Entered { get; internal set; }

    /// <summary>Claims about movement.</summary>
    public long Claims { get; internal set; }

    /// <summary>Claims not looked at because a client made too many.</summary>
    public long ClaimsOverRate { get; internal set; }

    /// <summary>Datagrams of nobody's session.</summary>
    public long ForeignDatagrams { get; internal set; }

    /// <summary>Sessions ended because their clients did not take what was sent.</summary>
    public long SlowClients { get; internal set; }

    /// <summary>Messages that could not be handled: mistakes in the server.</summary>
    public long Faults { get; internal set; }

    /// <summary>What all sessions have counted together, those that are over and those that are not.</summary>
    public SessionTotals Network { get; } = new();

    /// <summary>Logins refused for a reason.</summary>
    public long RefusedLogins(LoginRefusal reason) => refusedLogins[(int)reason];

    /// <summary>Claims refused, or put right, for a reason.</summary>
    public long RefusedClaims(ClaimReason reason) => refusedClaims[(int)reason];

    /// <summary>Claims refused, or put right, in all.</summary>
    public long AllRefusedClaims => refusedClaims.Sum();

    /// <summary>Datagrams or messages dropped for a reason.</summary>
    public long Dropped(DropReason reason) => dropped[(int)reason];

    internal void Refuse(LoginRefusal reason) => refusedLogins[(int)reason]++;

    internal void Refuse(ClaimReason reason) => refusedClaims[(int)reason]++;

    /// <summary>A session is over.</summary>
    internal void Add(SessionStatistics session)
    {
        ended.Add(session);
        foreach (DropReason reason in Enum.GetValues<DropReason>()) endedDrops[(int)reason] += session.Dropped(reason);
    }

    /// <summary>Adds up what all sessions have counted.</summary>
    internal void AddUp(IEnumerable<SessionStatistics> sessions)
    {
        sum.CopyFrom(ended);
        endedDrops.CopyTo(sumDrops, 0);
        foreach (SessionStatistics session in sessions)
        {
            sum.Add(session);
            for (int i = 0; i < sumDrops.Length; i++) sumDrops[i] += session.Dropped((DropReason)i);
        }

        Network.CopyFrom(sum);
        sumDrops.CopyTo(dropped, 0);
    }
}

/// <summary>Sums over sessions.</summary>
public sealed class SessionTotals
{
    /// <summary>Datagrams that arrived.</summary>
    public long DatagramsReceived { get; private set; }

    /// <summary>Their bytes.</summary>
    public long BytesReceived { get; private set; }

    /// <summary>Datagrams sent.</summary>
    public long DatagramsSent { get; private set; }

    /// <summary>Their bytes.</summary>
    public long BytesSent { get; private set; }

    /// <summary>Packets sent again because clients asked.</summary>
    public long Resent { get; private set; }

    /// <summary>Times that clients were asked to send again.</summary>
    public long RequestsSent { get; private set; }

    /// <summary>Messages received.</summary>
    public long MessagesReceived { get; private set; }

    /// <summary>Messages sent.</summary>
    public long MessagesSent { get; private set; }

    internal void CopyFrom(SessionTotals other)
    {
        (DatagramsReceived, BytesReceived, DatagramsSent, BytesSent) =
            (other.DatagramsReceived, other.BytesReceived, other.DatagramsSent, other.BytesSent);
        (Resent, RequestsSent, MessagesReceived, MessagesSent) =
            (other.Resent, other.RequestsSent, other.MessagesReceived, other.MessagesSent);
    }

    internal void Add(SessionStatistics session)
    {
        DatagramsReceived += session.DatagramsReceived;
        BytesReceived += session.BytesReceived;
        DatagramsSent += session.DatagramsSent;
        BytesSent += session.BytesSent;
        Resent += session.Resent;
        RequestsSent += session.RequestsSent;
        MessagesReceived += session.MessagesReceived;
        MessagesSent += session.MessagesSent;
    }
}
