using System.Numerics;

namespace Surefoot.DemoWorld.Land;

/// <summary>One of the two triangles of a terrain cell, in block coordinates.</summary>
/// <remarks>Only what it takes to put named places on the ground; the physics has its own terrain.</remarks>
internal readonly record struct TerrainTriangle(Vector3 A, Vector3 B, Vector3 C)
{
    /// <summary>Upward normal of length 1.</summary>
    public Vector3 Normal
    {
        get
        {
            double ux = (double)B.X - A.X, uy = (double)B.Y - A.Y, uz = (double)B.Z - A.Z;
            double vx = (double)C.X - A.X, vy = (double)C.Y - A.Y, vz = (double)C.Z - A.Z;
            double nx = (uy * vz) - (uz * vy), ny = (uz * vx) - (ux * vz), nz = (ux * vy) - (uy * vx);
            double length = Math.Sqrt((nx * nx) + (ny * ny) + (nz * nz));
            return new((float)(nx / length), (float)(ny / length), (float)(nz / length));
        }
    }

    /// <summary>Whether a cell is cut from its south-west to its north-east corner; otherwise from south-east to north-west.</summary>
    /// <param name="x">Cell column counted from the west end of the map.</param>
    /// <param name="y">Cell row counted from the south end of the map.</param>
    /// <remarks>Spec 05, 4.3. Retail: CLandBlockStruct::ConstructPolygons @0x00531D10.</remarks>
    public static bool CutsSouthWestToNorthEast(uint x, uint y)
    {
        uint hash = unchecked((y * ((214614067u * x) + 1813693831u)) - (1109124029u * x) - 1369149221u);
        return hash >= 0x80000000u;
    }

    /// <summary>Both triangles of cell (i, j) of a block, in retail's order.</summary>
    public static (TerrainTriangle First, TerrainTriangle Second) OfCell(DemoTerrain terrain, int blockX, int blockY, int i, int j)
    {
        var (column, row) = DemoTerrain.OriginOf(blockX, blockY);
        Vector3 Corner(int di, int dj) => new(24f * (i + di), 24f * (j + dj), terrain.Height(column + i + di, row + j + dj));
        Vector3 sw = Corner(0, 0), se = Corner(1, 0), nw = Corner(0, 1), ne = Corner(1, 1);
        return CutsSouthWestToNorthEast((uint)((8 * blockX) + i), (uint)((8 * blockY) + j))
            ? (new(sw, se, ne), new(sw, ne, nw))
            : (new(sw, se, nw), new(ne, nw, se));
    }

    /// <summary>The triangle under a point of cell (i, j); on the diagonal the first.</summary>
    public static TerrainTriangle Under(DemoTerrain terrain, int blockX, int blockY, int i, int j, float x, float y)
    {
        var (first, second) = OfCell(terrain, blockX, blockY, i, j);
        return first.Covers(x, y) ? first : second;
    }

    /// <summary>Height of the triangle's plane at a point (m).</summary>
    public float HeightAt(double x, double y)
    {
        var n = Normal;
        double d = -(((double)n.X * A.X) + ((double)n.Y * A.Y) + ((double)n.Z * A.Z));
        return (float)-(((y * n.Y) + (x * n.X) + d) / n.Z);
    }

    private bool Covers(double x, double y)
        => Turn(A, B, x, y) >= 0 && Turn(B, C, x, y) >= 0 && Turn(C, A, x, y) >= 0;

    private static double Turn(Vector3 from, Vector3 to, double x, double y)
        => (((double)to.X - from.X) * (y - from.Y)) - (((double)to.Y - from.Y) * (x - from.X));
}
