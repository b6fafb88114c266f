using System.Buffers;
using System.IO.MemoryMappedFiles;
using System.Runtime.InteropServices;

namespace Surefoot.Dats;

/// <summary>A file mapped for reading. Memory handed out is dead once the file is disposed.</summary>
internal sealed unsafe class MappedFile : IDisposable
{
    // A memory holds at most 2 GB and a dat file 4 GB: windows, overlapping by the greatest block so that any block lies within one.
    private const long WindowStep = 1L << 30;

    private readonly MemoryMappedFile? map;
    private readonly MemoryMappedViewAccessor? view;
    private readonly Window[] windows;
    private readonly byte* start;
    private volatile bool disposed;

    public MappedFile(string path)
    {
        using var stream = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.Read | FileShare.Delete, 1);
        Length = stream.Length;
        if (Length == 0)
        {
            windows = [];
            return;
        }

        map = MemoryMappedFile.CreateFromFile(stream, null, 0, MemoryMappedFileAccess.Read, HandleInheritability.None, leaveOpen: true);
        view = map.CreateViewAccessor(0, 0, MemoryMappedFileAccess.Read);
        byte* pointer = null;
        view.SafeMemoryMappedViewHandle.AcquirePointer(ref pointer);
        start = pointer + view.PointerOffset;
        windows = new Window[((Length - 1) / WindowStep) + 1];
        for (int i = 0; i < windows.Length; i++)
        {
            long offset = i * WindowStep;
            windows[i] = new Window(this, offset, (int)Math.Min(Length - offset, WindowStep + BlockReader.GreatestBlockSize));
        }
    }

    /// <summary>Bytes of the file.</summary>
    public long Length { get; }

    /// <summary>Bytes within the file; the caller has checked the range, which is no longer than a block.</summary>
    public ReadOnlyMemory<byte> Slice(long offset, int length)
    {
        ObjectDisposedException.ThrowIf(disposed, typeof(DatFile));
        return length == 0 ? default : windows[offset / WindowStep].Memory.Slice((int)(offset % WindowStep), length);
    }

    public void Dispose()
    {
        if (disposed)
            return;
        disposed = true;
        view?.SafeMemoryMappedViewHandle.ReleasePointer();
        view?.Dispose();
        map?.Dispose();
    }

    private sealed class Window(MappedFile file, long offset, int length) : MemoryManager<byte>
    {
        public override Span<byte> GetSpan()
        {
            ObjectDisposedException.ThrowIf(file.disposed, typeof(DatFile));
            return MemoryMarshal.CreateSpan(ref *(file.start + offset), length);
        }

        // The map does not move, so there is nothing to pin.
        public override MemoryHandle Pin(int elementIndex = 0)
        {
            ObjectDisposedException.ThrowIf(file.disposed, typeof(DatFile));
            return new MemoryHandle(file.start + offset + elementIndex);
        }

        public override void Unpin()
        {
        }

        protected override void Dispose(bool disposing)
        {
        }
    }
}
