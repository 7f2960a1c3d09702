#pragma once

#include "testbench/host/mesh/mesh.h"

namespace repousse::host {

/// A flat grid of columns x rows quads over [0, size.x] x [0, size.y] in the plane z = 0, normal
/// +z, tangent +x, uv = (i / columns, j / rows). Each quad is cut along its diagonal
/// (0,0)-(1,1): with a = j * (columns + 1) + i the triangles are (a, a+1, a+columns+2) and
/// (a, a+columns+2, a+columns+1), quads in row-major order. This order is the one in which the
/// paper's figure 10 scene was measured, and results depend on it (edges are visited 12, 23, 31).
/// Ranges: columns, rows 1..4096; size > 0.
Mesh make_grid(int columns, int rows, glm::dvec2 size = {1.0, 1.0});

/// The side of a cylinder around the z axis, z in [0, height]: u runs once round (counter-
/// clockwise seen from above), v upwards, normals outwards, tangent along +u. The column u = 1
/// repeats the column u = 0 with bit-identical positions, normals and tangents, so a map that
/// wraps in u closes without a crack. Same triangle order as the grid.
/// Ranges: segments 3..4096, rings 1..4096 (quads along the height), radius > 0, height > 0.
Mesh make_cylinder(int segments, int rings, double radius, double height);

/// A sphere around the origin: an icosahedron with a vertex at each pole, its 20 triangles split
/// in four `subdivisions` times and pushed out to `radius`. 20 * 4^subdivisions triangles.
///
/// UV is the spherical projection: u = azimuth / 2 pi, v = 0 at the south pole, 1 at the north
/// pole. Duplicates: a triangle across the meridian u = 0 gets copies of its low-u vertices with
/// u + 1 (so u reaches about 1.2 and the map must wrap in u), and each triangle at a pole gets a
/// copy of the pole with the mean u of its other two vertices. All copies hold bit-identical
/// positions and normals; u is a multiple of 2^-30, so that u + 1 is exact and both sides of the
/// seam reach the same texel. Range: subdivisions 0..8, radius > 0.
Mesh make_icosphere(int subdivisions, double radius);

}  // namespace repousse::host
