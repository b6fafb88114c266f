namespace Surefoot.Physics.Bodies;

/// <summary>What a body did about a position of a server.</summary>
public enum PositionUpdate
{
    /// <summary>Nothing: it falls, and the server's body did not stand.</summary>
    Ignored,

    /// <summary>Follows it.</summary>
    Interpolated,

    /// <summary>Was put there, being far from the local player.</summary>
    Placed,

    /// <summary>Was teleported there.</summary>
    Teleported,
}
