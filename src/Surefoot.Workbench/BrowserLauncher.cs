using System.ComponentModel;
using System.Diagnostics;

namespace Surefoot.Workbench;

/// <summary>Opens an address in the person's browser.</summary>
public static class BrowserLauncher
{
    /// <summary>Opens the address where there is a display. Nothing is thrown: a person can still type the address.</summary>
    /// <param name="address">What to open.</param>
    /// <returns>False where there is no display or nothing to open it with.</returns>
    public static bool TryOpen(Uri address)
    {
        ArgumentNullException.ThrowIfNull(address);
        ProcessStartInfo? start = Command(address.AbsoluteUri);
        if (start is null) return false;
        try
        {
            using Process? process = Process.Start(start);
            return true;
        }
        catch (Exception missing)
            when (missing is Win32Exception or FileNotFoundException or InvalidOperationException or PlatformNotSupportedException)
        {
            return false;
        }
    }

    private static ProcessStartInfo? Command(string address)
    {
        if (OperatingSystem.IsWindows()) return new ProcessStartInfo(address) { UseShellExecute = true };
        if (OperatingSystem.IsMacOS()) return new ProcessStartInfo("open", [address]);
        bool display = Has("DISPLAY") || Has("WAYLAND_DISPLAY");
        return display ? new ProcessStartInfo("xdg-open", [address]) { RedirectStandardError = true, RedirectStandardOutput = true } : null;
    }

    private static bool Has(string variable) => !string.IsNullOrEmpty(Environment.GetEnvironmentVariable(variable));
}
