namespace Surefoot.Physics;
internal static class Marker;
