using System.Collections.Frozen;
using System.IO.Compression;
using System.Reflection;
using System.Security.Cryptography;
using Microsoft.AspNetCore.Http;
using Microsoft.Net.Http.Headers;

namespace Surefoot.Workbench.Hosting;

/// <summary>
/// The built page, embedded in this assembly under <c>page/</c>; text goes over the wire compressed where the browser takes it.
/// </summary>
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
            found[name[Prefix.Length..]] = new PageFile(bytes, type);
        }

        files = found.ToFrozenDictionary(StringComparer.Ordinal);
    }

    /// <summary>Answers with a file of the page, or 404.</summary>
    public IResult Serve(HttpContext context, string? path)
    {
        if (!files.TryGetValue(string.IsNullOrEmpty(path) ? "index.html" : path, out PageFile? file)) return Results.NotFound();
        (byte[] bytes, string? encoding, string tag) = file.For(context.Request.Headers.AcceptEncoding.ToString());
        IHeaderDictionary headers = context.Response.Headers;
        headers.ETag = tag;
        headers.CacheControl = "no-cache";
        if (file.IsText) headers.Vary = HeaderNames.AcceptEncoding;
        if (context.Request.Headers.IfNoneMatch == tag) return Results.StatusCode(StatusCodes.Status304NotModified);
        if (encoding is not null) headers.ContentEncoding = encoding;
        return Results.Bytes(bytes, file.ContentType);
    }

    /// <summary>A file, and what it is when compressed; each form is made when it is first asked for.</summary>
    private sealed class PageFile(byte[] bytes, string contentType)
    {
        private readonly string hash = Convert.ToHexStringLower(SHA256.HashData(bytes))[..16];
        private readonly Lazy<byte[]> brotli = new(() => Compress(bytes, to => new BrotliStream(to, CompressionLevel.Optimal)));
        private readonly Lazy<byte[]> gzip = new(() => Compress(bytes, to => new GZipStream(to, CompressionLevel.Optimal)));

        public string ContentType => contentType;

        public bool IsText => contentType.StartsWith("text/", StringComparison.Ordinal) || contentType == "image/svg+xml";

        /// <summary>The form that a browser takes.</summary>
        /// <param name="accepted">Its header Accept-Encoding.</param>
        public (byte[] Bytes, string? Encoding, string Tag) For(string accepted)
        {
            if (IsText && Accepts(accepted, "br")) return (brotli.Value, "br", $"\"{hash}-br\"");
            if (IsText && Accepts(accepted, "gzip")) return (gzip.Value, "gzip", $"\"{hash}-gzip\"");
            return (bytes, null, $"\"{hash}\"");
        }

        private static bool Accepts(string header, string encoding) =>
            StringWithQualityHeaderValue.TryParseList([header], out IList<StringWithQualityHeaderValue>? list) &&
            list.Any(one => one.Value.Equals(encoding, StringComparison.OrdinalIgnoreCase) && one.Quality is not 0);

        private static byte[] Compress(byte[] bytes, Func<Stream, Stream> around)
        {
            using MemoryStream packed = new();
            using (Stream stream = around(packed)) stream.Write(bytes);
            return packed.ToArray();
        }
    }
}
