using System.Collections.Frozen;
using System.Reflection;
using System.Security.Cryptography;
using Microsoft.AspNetCore.Http;

namespace Surefoot.Workbench.Hosting;

/// <summary>The built page, embedded in this assembly under <c>page/</c>.</summary>
internal sealed class PageFiles
{
    private const string Prefix = "page/";

    private static readonly FrozenDictionary<string, string> ContentTypes = new Dictionary<string, string>
    {
        [".html"] = "text/html; charset=utf-8",
        [".js"] = "text/javascript; charset=utf-8",
        [".css"] = "text/css; charset=utf-8",
        [".svg"] = "image/svg+xml",
        [".png"] = "image/png",
    }.ToFrozenDictionary(StringComparer.Ordinal);

    private readonly FrozenDictionary<string, PageFile> files;

    public PageFiles()
    {
        Assembly assembly = typeof(PageFiles).Assembly;
        Dictionary<string, PageFile> found = [];
        foreach (string name in assembly.GetManifestResourceNames())
        {
            if (!name.StartsWith(Prefix, StringComparison.Ordinal)) continue;
            using Stream stream = assembly.GetManifestResourceStream(name)!;
            byte[] bytes = new byte[stream.Length];
            stream.ReadExactly(bytes);
            string type = ContentTypes.GetValueOrDefault(Path.GetExtension(name), "application/octet-stream");
            found[name[Prefix.Length..]] = new PageFile(bytes, type, $"\"{Convert.ToHexStringLower(SHA256.HashData(bytes))[..16]}\"");
        }

        files = found.ToFrozenDictionary(StringComparer.Ordinal);
    }

    /// <summary>Answers with a file of the page, or 404.</summary>
    public IResult Serve(HttpContext context, string? path)
    {
        if (!files.TryGetValue(string.IsNullOrEmpty(path) ? "index.html" : path, out PageFile? file)) return Results.NotFound();
        context.Response.Headers.ETag = file.Tag;
        context.Response.Headers.CacheControl = "no-cache";
        if (context.Request.Headers.IfNoneMatch == file.Tag) return Results.StatusCode(StatusCodes.Status304NotModified);
        return Results.Bytes(file.Bytes, file.ContentType);
    }

    private sealed record PageFile(byte[] Bytes, string ContentType, string Tag);
}
