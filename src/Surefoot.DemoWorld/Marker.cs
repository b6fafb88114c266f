namespace Surefoot.DemoWorld;
internal static class Marker;
