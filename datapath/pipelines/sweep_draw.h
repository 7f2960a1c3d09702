#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "datapath/map_view.h"
#include "datapath/paged_array.h"
#include "datapath/pipelines/draw.h"
#include "datapath/sweep_items.h"
#include "datapath/units/grid_transform.h"
#include "datapath/units/shade.h"
#include "datapath/units/triangle_setup.h"
#include "datapath/units/view_clip.h"

namespace repousse {

/// The registers of sweep-line remeshing.
template <class P>
struct SweepRegisters {
    bool use_bump = false;   ///< displaced normals are wanted: 13 components, else 9
    bool use_shade = false;  ///< colours are wanted
    bool use_clip = true;    ///< trivially reject triangles outside the extended view volume
    GridRegisters<P> grid;
    ClipRegisters<P> clip;
    TriangleSetupRegisters setup;
    ShadeRegisters<P> shade;
};

/// A base triangle as the controller reads it.
template <class P>
struct SweepBase {
    std::array<uint32_t, 3> vertices{};
    typename P::Value max_displacement{};  ///< displacement format, >= |D| anywhere on it
    bool direct = false;                   ///< not displaced: straight to the triangle buffer
};

/// All that the device gets for one object that is remeshed by sweep lines.
template <class P>
struct SweepDraw {
    std::vector<Vertex<P>> vertices;  ///< uv, position, normal, tangent, handedness
    std::vector<SweepBase<P>> triangles;
    MapTables<P> tables;
    MapView<P> map;  ///< its spans are set by `view()`
    ViewRegisters<P> camera;
    SweepRegisters<P> registers;
    std::vector<uint32_t> z_table;  ///< ZTableKind::Uniform only

    /// The map registers with the spans of this draw's own tables.
    MapView<P> view() const {
        MapView<P> bound = map;
        bound.heights = tables.heights;
        bound.normals = tables.normals;
        bound.turns = tables.turns;
        return bound;
    }
};

/// What a draw gives: base triangle by base triangle, in the order in which strips made them.
template <class P>
struct SweepMesh {
    PagedArray<SweepOutputVertex<P>> vertices;
    PagedArray<FineTriangle> triangles;

    void append(Span<const SweepOutputVertex<P>> some) { vertices.append(some); }
    void append(Span<const FineTriangle> some) { triangles.append(some); }
    const SweepOutputVertex<P>& corner(const FineTriangle& triangle, std::size_t k) const {
        return vertices[triangle.vertices[k]];
    }
};

}  // namespace repousse
