namespace Surefoot.Workbench.Tests.Support;

/// <summary>Waits for what other threads bring about.</summary>
internal static class Eventually
{
    public static async Task Holds(Func<bool> condition, string what)
    {
        for (int i = 0; i < 2000; i++)
        {
            if (condition()) return;
            await Task.Delay(10);
        }

        Assert.Fail($"Did not happen: {what}");
    }
}
