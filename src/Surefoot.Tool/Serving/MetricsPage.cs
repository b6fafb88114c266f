using System.Globalization;
using System.Net;
using Prometheus;

namespace Surefoot.Tool.Serving;

/// <summary>A page of a server's metrics as Prometheus reads it, on this machine alone.</summary>
internal sealed class MetricsPage : IDisposable
{
    private const string Meter = "Surefoot.Server";

    private readonly IDisposable adapter;
    private readonly MetricServer page;

    /// <summary>Opens the page.</summary>
    /// <param name="port">Its port.</param>
    /// <exception cref="IOException">The port is taken.</exception>
    internal MetricsPage(int port)
    {
        CollectorRegistry registry = Metrics.NewCustomRegistry();
        adapter = MeterAdapter.StartListening(new MeterAdapterOptions
        {
            InstrumentFilterPredicate = instrument => instrument.Meter.Name == Meter,
            Registry = registry,
            MetricFactory = Metrics.WithCustomRegistry(registry),
            ResolveHistogramBuckets = _ => [0.0001, 0.0002, 0.0005, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1],
        });
        page = new MetricServer("127.0.0.1", port, registry: registry);
        try
        {
            page.Start();
        }
        catch (HttpListenerException error)
        {
            adapter.Dispose();
            throw new IOException(
                string.Create(CultureInfo.InvariantCulture, $"The page of metrics cannot open port {port}: {error.Message}"), error);
        }

        Address = new Uri(string.Create(CultureInfo.InvariantCulture, $"http://127.0.0.1:{port}/metrics"));
    }

    /// <summary>Where it is.</summary>
    internal Uri Address { get; }

    public void Dispose()
    {
        adapter.Dispose();
        page.Stop();
    }
}
