namespace Surefoot.Protocol.Session;

/// <summary>Objects of which messages came but no description: when to ask for it again, and when to give up (specification 08, 4.3 and
/// 5.6).</summary>
internal sealed class ObjectRequests
{
    /// <summary>Most objects waited for; further ones are not asked for.</summary>
    public const int Most = 1024;

    private const double RequestInterval = 20, Life = 25;

    private readonly Dictionary<uint, Wait> waits = [];

    /// <summary>Objects waited for.</summary>
    public int Count => waits.Count;

    /// <summary>A message for an unknown object came: its life begins anew.</summary>
    public void Await(uint guid, double now)
    {
        if (waits.TryGetValue(guid, out Wait wait))
            waits[guid] = wait with { LastMessage = now };
        else if (waits.Count < Most)
            waits.Add(guid, new Wait(now, now));
    }

    /// <summary>The object came, or is not of interest any more.</summary>
    public void Forget(uint guid) => waits.Remove(guid);

    /// <summary>Nothing is waited for any more.</summary>
    public void Clear() => waits.Clear();

    /// <summary>Finds an object that is to be asked for now; call it again until there is none.</summary>
    public bool TryTakeDue(double now, out uint guid)
    {
        foreach ((uint candidate, Wait wait) in waits)
        {
            if (now - wait.LastMessage > Life)
            {
                waits.Remove(candidate);
            }
            else if (now - wait.LastRequest > RequestInterval)
            {
                waits[candidate] = wait with { LastRequest = now };
                guid = candidate;
                return true;
            }
        }

        guid = 0;
        return false;
    }

    private readonly record struct Wait(double LastMessage, double LastRequest);
}
