#pragma once

#include <string>

#include "testbench/host/draw.h"
#include "testbench/reference/tessellator.h"

namespace repousse::test {

/// What the device is asked to draw, for the reference tessellator: doubles as they are, texture
/// coordinates truncated to `uv_frac` bits.
reference::TessellatorInput reference_input(const host::DrawInputs& inputs, int uv_frac);

/// A map for tests on real relief: columns x..x+width, rows y..y+height of the Jacksboro elevation
/// file (scenes/fetch.sh gets it), quantised over the file's full range. `real` says whether the
/// file is there; otherwise the map is fractal noise of the same size, from a fixed seed.
struct Relief {
    host::HeightMap map;
    bool real = false;
};
Relief jacksboro_relief(int x, int y, int width, int height);

/// An object on its own: what DrawInputs points into, kept together.
struct Object {
    host::Mesh mesh;
    host::HeightMap map;
    host::AdaptiveSettings settings;
    host::HeightFilter filter = host::HeightFilter::Nearest;
    host::UvSpan uv = host::UvSpan::Edges;

    /// Valid as long as the object stays where it is.
    host::DrawInputs inputs() const;
};

}  // namespace repousse::test
