namespace Surefoot;

/// <summary>A place where no player can be. The message says why, and what to do.</summary>
public sealed class PlaceException : Exception
{
    internal PlaceException(string message)
        : base(message)
    {
    }
}
