namespace Surefoot.Workbench;
internal static class Marker;
