#pragma once

#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "datapath/profile.h"
#include "datapath/sweep_items.h"
#include "datapath/units/grid_transform.h"
#include "datapath/units/perspective.h"
#include "datapath/units/strip.h"
#include "datapath/units/sweep_line.h"
#include "datapath/units/triangle_setup.h"
#include "testbench/host/encoder.h"
#include "testbench/host/mesh/mesh.h"
#include "testbench/host/scene/scene.h"
#include "testbench/host/z_table.h"
#include "testbench/reference/fine_mesh.h"

namespace repousse::study {

/// The mesh with one vertex for each position, so that a texture seam is no seam of the surface;
/// each keeps the attributes of its first copy. Tangents are dropped.
host::Mesh welded(const host::Mesh& mesh);

/// A cylinder with both ends closed by fans: a closed mesh with long thin triangles and two
/// vertices of many edges. Welded. Ranges as host::make_cylinder.
host::Mesh make_capped_cylinder(int segments, int rings, double radius, double height);

/// A camera that looks at, or from within, the ball around the origin. `inside`: the eye is in the
/// inner half of the ball; otherwise between 1.02 and 4 radii from its centre.
host::CameraSettings random_camera(std::mt19937_64& random, double radius, bool inside);

/// How a mesh is remeshed.
struct MeshSetting {
    AdderKind adder = AdderKind::Exact;
    int guard_bits = 0;
    int data_frac = 16;    ///< fraction bits of `sweep_data`
    int column_depth = 0;  ///< 0: one lane
    int guard_grid = kGridLimit;
    double w_min = 0.05;  ///< world units
};

/// What remeshing a mesh under one camera gave.
struct MeshFigures {
    reference::FineReport mesh;
    uint64_t clamped_w = 0;         ///< base vertices at the clamp of w, the eye or behind it
    uint64_t clamped_grid = 0;      ///< base corners that the guard band moved
    double edge_error_ulp = 0;      ///< largest distance of an edge vertex from the true v * c
    uint64_t edge_beyond_half = 0;  ///< edge vertices with a component further than 0.5 ulp
    double edge_error_px = 0;  ///< largest distance of an edge vertex behind `perspective` from
                               ///< the true point, on the screen
    uint64_t overflows = 0;    ///< vertex data that left their format
    uint64_t runaways = 0;
    uint64_t bad_refs = 0;
};

/// Remeshes whole meshes with the device's units and judges the result by name.
class MeshRemesher {
public:
    /// `mesh` is welded, within the formats of the profile, and outlives this.
    MeshRemesher(const Profile& profile, const host::Mesh& mesh);

    /// One camera; a grid unit is a pixel.
    MeshFigures run(const host::CameraSettings& camera, const host::Viewport& viewport,
                    const MeshSetting& setting);

private:
    host::GridCamera grid_camera(const host::CameraSettings& camera, const host::Viewport& viewport,
                                 const MeshSetting& setting) const;
    void place_corners(const host::GridCamera& camera, const MeshSetting& setting,
                       const Profile& profile, TriangleSetup& setup, MeshFigures& figures);

    Profile profile_;
    const host::Mesh& mesh_;
    std::vector<SweepCorner> corners_;  // by base vertex
    reference::FineMeshChecker checker_;
};

}  // namespace repousse::study
