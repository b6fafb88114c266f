namespace Surefoot.Protocol;

internal static class Marker;
