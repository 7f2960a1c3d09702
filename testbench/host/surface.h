#pragma once

#include <vector>

#include "datapath/pipelines/contexts.h"
#include "datapath/pipelines/sweep_draw.h"
#include "datapath/profile.h"
#include "testbench/host/draw.h"
#include "testbench/host/mesh/mesh.h"
#include "testbench/host/view/render_mesh.h"

namespace repousse::host {

/// The device's finished triangles as a mesh in doubles. Corners with the same bits are one
/// vertex, so vertices that are the same vertex have the same bits in the file, too. Normals are
/// there if the draw made them, and so are colours. Vertices are numbered by first use.
template <class P>
Mesh surface_mesh(const std::vector<OutputTriangle<P>>& triangles, const Profile& profile,
                  const DrawInputs& inputs);
template <class P>
Mesh surface_mesh(const SweepMesh<P>& mesh, const Profile& profile, const DrawInputs& inputs);

/// The same for the view: with the map's height at each vertex, 0..1, for the relief tint.
RenderMesh surface_view(const Mesh& surface, const DrawInputs& inputs);

}  // namespace repousse::host
