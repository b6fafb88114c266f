namespace Surefoot.Server;

/// <summary>How often logins of one address are looked at. Its memory is fixed, whatever comes: addresses share its places.</summary>
/// <param name="perSecond">Logins a second.</param>
internal sealed class LoginGate(double perSecond)
{
    private const int Places = 4096;
    private const double BurstSeconds = 4;

    private readonly double[] emptyAt = new double[Places];

    /// <summary>A login of this address is to be looked at.</summary>
    public bool TryPass(ClientAddress from, double now)
    {
        ref double empty = ref emptyAt[(uint)from.Network.GetHashCode() % Places];
        double filled = Math.Max(empty, now) + (1 / perSecond);
        if (filled - now > BurstSeconds) return false;
        empty = filled;
        return true;
    }
}
