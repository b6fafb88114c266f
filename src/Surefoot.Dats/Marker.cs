namespace Surefoot.Dats;
internal static class Marker;
