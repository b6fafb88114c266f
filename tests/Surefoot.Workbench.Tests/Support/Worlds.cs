namespace Surefoot.Workbench.Tests.Support;

internal static class Worlds
{
    public static Task<WorkbenchServer> StartAsync() => WorkbenchServer.StartAsync(new WorkbenchOptions { Port = 0 });
}
