#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "datapath/items.h"
#include "datapath/map_view.h"
#include "datapath/numbers/policy.h"
#include "datapath/units/height_test.h"
#include "datapath/units/normal_test.h"
#include "datapath/units/shade.h"
#include "datapath/units/triangle_stack.h"
#include "datapath/units/vertex_transform.h"

namespace repousse {

/// The registers of adaptive tessellation. A test that is not used never looks at its threshold.
template <class P>
struct AdaptiveRegisters {
    bool use_view_test = false;
    bool use_normal_test = false;
    bool use_height_test = false;
    bool use_bump = false;   ///< displaced normals are wanted, by the normal test or as output
    bool use_shade = false;  ///< colours are wanted
    bool eager = false;      ///< never skip a test
    int cap = 0;             ///< generation cap, 0 to 15
    StackOrder order = StackOrder::Lifo;
    NormalSpace normal_space = NormalSpace::World;
    typename P::Wide view_threshold{};     ///< pixels, in the format of `screen`
    typename P::Value normal_threshold{};  ///< in the format of `displaced_normal`
    HeightTestRegisters height_test;
    ShadeRegisters<P> shade;
};

/// The tables that a map view points into.
template <class P>
struct MapTables {
    std::vector<uint16_t> heights;
    std::vector<Vec3<typename P::Texel>> normals;  ///< empty unless bump of kind 0 is used
    std::vector<Turn<typename P::Texel>> turns;    ///< empty unless bump of kind 2 is used
    std::vector<uint64_t> sums;                    ///< empty unless the height test is used
};

/// All that the device gets for one object: base mesh, tables and registers, in its own formats.
/// Vertices need uv, position, normal, tangent and handedness.
template <class P>
struct AdaptiveDraw {
    std::vector<Vertex<P>> vertices;
    std::vector<std::array<uint32_t, 3>> triangles;
    MapTables<P> tables;
    MapView<P> map;  ///< its spans are set by `view()`
    ViewRegisters<P> camera;
    AdaptiveRegisters<P> registers;

    /// The map registers with the spans of this draw's own tables.
    MapView<P> view() const {
        MapView<P> bound = map;
        bound.heights = tables.heights;
        bound.normals = tables.normals;
        bound.turns = tables.turns;
        bound.sums = tables.sums;
        return bound;
    }

    /// Base triangle i with its three corners.
    Triangle<P> base_triangle(std::size_t i) const {
        Triangle<P> triangle;
        for (std::size_t k = 0; k < 3; ++k) triangle.corners[k] = vertices[triangles[i][k]];
        return triangle;
    }
};

}  // namespace repousse
