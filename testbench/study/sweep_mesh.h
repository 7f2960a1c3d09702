#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "datapath/profile.h"
#include "datapath/sweep_items.h"
#include "datapath/units/displace.h"
#include "datapath/units/footprint.h"
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

/// How a mesh is remeshed.
struct MeshSetting {
    AdderKind adder = AdderKind::Exact;
    int guard_bits = 0;
    int data_frac = 16;    ///< fraction bits of `sweep_data`
    int column_depth = 0;  ///< 0: one lane
    int guard_grid = kGridLimit;
    double w_min = 0.05;  ///< world units
    /// Displaces the vertices, by footprints if the filter reads levels; null: they stay.
    const MapView<Fixed>* map = nullptr;
    bool edge_rule = true;  ///< false, to show what it is for: edges have the sweep's footprint
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
    FootprintCounters footprints;
    /// Fine edges by how many filter levels their ends are apart; of these, those with a corner.
    std::array<uint64_t, kMostLevels + 1> jumps{};
    std::array<uint64_t, kMostLevels + 1> corner_jumps{};
    uint64_t mixed = 0;  ///< fine edges with one end seen from the front and one from the back
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
    /// What a vertex read of the map.
    struct Read {
        LevelRead read;
        bool is_corner = false;
    };
    static void count_jumps(const std::array<const Read*, 3>& reads, MeshFigures& figures);
    void prepare(const Profile& profile, const MeshSetting& setting);
    void finish_vertex(const SweepVertex& vertex, const SweepTriangle& base,
                       const MeshSetting& setting, FineVertex<Fixed>& fine);
    void place_corners(const host::GridCamera& camera, const MeshSetting& setting,
                       const Profile& profile, TriangleSetup& setup, MeshFigures& figures);

    Profile profile_;
    const host::Mesh& mesh_;
    std::vector<SweepCorner> corners_;  // by base vertex
    Vec3<int32_t> eye_;
    std::optional<Perspective<Fixed>> perspective_;
    std::optional<Footprint<Fixed>> footprint_;
    std::optional<Displace<Fixed>> displace_;
    reference::FineMeshChecker checker_;
};

}  // namespace repousse::study
