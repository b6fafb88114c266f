using System.Numerics;
using Surefoot.DemoWorld.Placement;

namespace Surefoot.DemoWorld;

/// <summary>A place of the demo world that people, scripts and tests call by name.</summary>
/// <param name="Name">Short name in kebab-case, unique: "lake-shore".</param>
/// <param name="Title">The name as a person would say it.</param>
/// <param name="CellId">The cell, e.g. 0xA9B40011.</param>
/// <param name="Origin">Where feet stand: metres from the south-west corner of the cell's block, x east, y north, z up.</param>
/// <param name="Heading">Where one looks: degrees clockwise from north (+y), 0 up to 360.</param>
/// <param name="WhatToTry">One sentence on what there is to try.</param>
public sealed record NamedPlace(string Name, string Title, uint CellId, Vector3 Origin, float Heading, string WhatToTry)
{
    /// <summary>The heading as a rotation about +z, of length 1.</summary>
    public Quaternion Orientation => new Spot(0, 0, 0, Heading).ToFrame().Rotation;
}
