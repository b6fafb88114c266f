namespace Surefoot.Client;
internal static class Marker;
