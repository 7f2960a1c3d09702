#pragma once

#include <vector>

#include "testbench/host/scene/scene.h"
#include "testbench/host/view/picture.h"
#include "testbench/host/view/render_mesh.h"

namespace repousse::host {

/// Draws surfaces with a z buffer, Phong lighting and, where the view asks for them, relief tint,
/// wireframe, shadows of the first light and a block's sides. Depth is 1/w; attributes are
/// perspective-correct; each pixel has samples x samples depth samples and is shaded once per
/// triangle that holds some of them. The same input gives the same picture.
///
/// Surfaces that have colours are drawn with these, interpolated: no light, tint or shadow of the
/// view falls on them. Surfaces without normals get area-weighted ones, or one a face with
/// Shading::Flat.
Picture render(const std::vector<RenderMesh>& surfaces, const CameraSettings& camera,
               const Viewport& viewport, const ViewSettings& view,
               const std::vector<Light>& lights);

/// As above, with the camera, lights and view of a scene.
Picture render_scene(const Scene& scene, const std::vector<RenderMesh>& surfaces);

}  // namespace repousse::host
