using System.Numerics;
using Surefoot.Physics.Geometry;

namespace Surefoot.Physics.World;

/// <summary>
/// The ground of one landblock: 9 × 9 heights, 64 cells of two triangles each, and what the ground is made of. Immutable; all coordinates
/// are the block's, metres.
/// </summary>
/// <remarks>
/// Retail: CLandBlockStruct at full detail; specification 05, 4.3 to 4.6. Cell (i, j) is the i-th from the west and j-th from the south,
/// its index 8·i + j; it owns the triangles 2·index and 2·index + 1.
/// </remarks>
public sealed partial class TerrainSurface
{
    /// <summary>Cells along a side.</summary>
    public const int CellsPerSide = 8;

    /// <summary>Vertices along a side.</summary>
    public const int VerticesPerSide = 9;

    /// <summary>Vertices of a block.</summary>
    public const int VertexCount = VerticesPerSide * VerticesPerSide;

    /// <summary>Cells of a block.</summary>
    public const int CellCount = CellsPerSide * CellsPerSide;

    /// <summary>Triangles of a block.</summary>
    public const int TriangleCount = 2 * CellCount;

    private readonly float[] heights;
    private readonly ushort[] words;
    private readonly Plane[] planes = new Plane[TriangleCount];
    private readonly ulong southWestToNorthEast;

    /// <summary>The ground of a block.</summary>
    /// <param name="blockId">Any id of the block; its place on the map decides how the cells are cut.</param>
    /// <param name="heights">81 heights, index 9·column + row, metres.</param>
    /// <param name="words">81 terrain words at the same index (specification 05, 2.6).</param>
    /// <exception cref="ArgumentException">Not 81 of each.</exception>
    public TerrainSurface(uint blockId, ReadOnlySpan<float> heights, ReadOnlySpan<ushort> words)
    {
        if (heights.Length != VertexCount || words.Length != VertexCount)
            throw new ArgumentException("A block has 81 heights and 81 terrain words.");
        BlockId = CellIds.BlockOf(blockId);
        this.heights = heights.ToArray();
        this.words = words.ToArray();
        uint cornerX = CellsPerSide * (blockId >> 24), cornerY = CellsPerSide * ((blockId >> 16) & 0xFF);
        Span<Vector3> corners = stackalloc Vector3[3];
        for (int cell = 0; cell < CellCount; cell++)
        {
            if (IsCutSouthWestToNorthEast(cornerX + (uint)(cell >> 3), cornerY + (uint)(cell & 7))) southWestToNorthEast |= 1UL << cell;
            for (int triangle = 2 * cell; triangle < (2 * cell) + 2; triangle++)
            {
                CopyCorners(triangle, corners);
                planes[triangle] = ConvexPolygon.MakePlane(corners);
            }
        }

        BlockWaterType = FindWater();
    }

    /// <summary>The block, 0xXXYY0000.</summary>
    public uint BlockId { get; }

    /// <summary>
    /// How the cell at global cell coordinates is cut: true from south-west to north-east, false from south-east to north-west.
    /// </summary>
    /// <remarks>Retail: CLandBlockStruct::ConstructPolygons @0x00531D10. All arithmetic wraps at 32 bits; the top bit decides.</remarks>
    internal static bool IsCutSouthWestToNorthEast(uint x, uint y) => SplitHash(x, y) >> 31 != 0;

    /// <summary>The pseudo-random number that decides how a cell is cut.</summary>
    internal static uint SplitHash(uint x, uint y) =>
        unchecked((y * ((214614067u * x) + 1813693831u)) - (1109124029u * x) - 1369149221u);

    /// <summary>Is this cell of the block cut from south-west to north-east?</summary>
    public bool IsCutSouthWestToNorthEast(int cell) => ((southWestToNorthEast >> cell) & 1) != 0;

    /// <summary>Plane of a triangle, its normal upwards.</summary>
    public ref readonly Plane PlaneOf(int triangle) => ref planes[triangle];

    /// <summary>Writes the three corners of a triangle, counter-clockwise seen from above, in retail's order.</summary>
    public void CopyCorners(int triangle, Span<Vector3> corners)
    {
        Corners order = CornersOf(triangle);
        corners[0] = Vertex(order.A);
        corners[1] = Vertex(order.B);
        corners[2] = Vertex(order.C);
    }

    /// <summary>
    /// The triangle of a cell that a point is over, −1 for none. The first of the two wins on their common edge, and a point on the border
    /// of two cells is in both.
    /// </summary>
    /// <remarks>Retail: CLandCell::find_terrain_poly @0x00532CF0.</remarks>
    internal int FindTriangle(int cell, in Vector3 point)
    {
        if (IsOver(2 * cell, point)) return 2 * cell;
        return IsOver((2 * cell) + 1, point) ? (2 * cell) + 1 : -1;
    }

    /// <summary>Height of the ground at a point, metres; false outside the block.</summary>
    public bool TryGetHeight(float x, float y, out float z)
    {
        z = 0;
        if (!(x >= 0 && y >= 0 && x <= CellIds.BlockSize && y <= CellIds.BlockSize)) return false;
        Vector3 point = new(x, y, 0);
        int triangle = FindTriangle(CellUnder(x, y), point);
        if (triangle < 0 || !PlaneQueries.SetHeight(planes[triangle], ref point)) return false;
        z = point.Z;
        return true;
    }

    /// <summary>The cell under a point of the block; the block's far borders belong to its last cells.</summary>
    internal static int CellUnder(float x, float y) =>
        (CellsPerSide * Math.Min((int)(x / (double)CellIds.CellSize), CellsPerSide - 1)) +
        Math.Min((int)(y / (double)CellIds.CellSize), CellsPerSide - 1);

    /// <remarks>Retail: CPolygon::point_in_poly2D @0x00538060, which walks the corners backwards; points on an edge are inside.</remarks>
    private bool IsOver(int triangle, in Vector3 point)
    {
        Corners order = CornersOf(triangle);
        Vector2 a = Place(order.A), b = Place(order.B), c = Place(order.C);
        return !(IsOutsideEdge(a, c, point) || IsOutsideEdge(c, b, point) || IsOutsideEdge(b, a, point));
    }

    private static bool IsOutsideEdge(Vector2 previous, Vector2 current, in Vector3 point)
    {
        double dy = (double)previous.Y - current.Y, dx = (double)current.X - previous.X;
        return -(dy * current.X) - (dx * current.Y) + (dx * point.Y) + (dy * point.X) > 0;
    }

    private Corners CornersOf(int triangle)
    {
        int cell = triangle >> 1;
        int southWest = (VerticesPerSide * (cell >> 3)) + (cell & 7);
        int northWest = southWest + 1, southEast = southWest + VerticesPerSide, northEast = southEast + 1;
        bool first = (triangle & 1) == 0;
        if (IsCutSouthWestToNorthEast(cell)) return first ? new(southWest, southEast, northEast) : new(southWest, northEast, northWest);
        return first ? new(southWest, southEast, northWest) : new(northEast, northWest, southEast);
    }

    private static Vector2 Place(int vertex) =>
        new(CellIds.CellSize * (vertex / VerticesPerSide), CellIds.CellSize * (vertex % VerticesPerSide));

    private Vector3 Vertex(int vertex) => new(Place(vertex), heights[vertex]);

    /// <summary>Three vertices of the block.</summary>
    private readonly record struct Corners(int A, int B, int C);
}
