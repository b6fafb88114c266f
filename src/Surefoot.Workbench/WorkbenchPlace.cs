using System.Numerics;

namespace Surefoot.Workbench;

/// <summary>A named place that the page's menu offers.</summary>
/// <param name="Name">Shown in the menu; unique.</param>
/// <param name="CellId">Cell, 0xXXYYCCCC.</param>
/// <param name="Position">Metres in the cell's landblock: x east, y north, z up.</param>
/// <param name="Yaw">Facing, radians about z, counter-clockwise from north.</param>
/// <param name="Hint">What there is to try there; null for nothing to say.</param>
/// <param name="LookFrom">
/// Where the page looks from at first: radians around the player, counter-clockwise from behind; 0 for over the shoulder. From the side a
/// slope is seen best.
/// </param>
public sealed record WorkbenchPlace(string Name, uint CellId, Vector3 Position, float Yaw, string? Hint = null, float LookFrom = 0);
