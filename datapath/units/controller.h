#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "datapath/items.h"
#include "datapath/numbers/cast.h"
#include "datapath/numbers/policy.h"
#include "datapath/profile.h"
#include "datapath/sweep_items.h"

namespace repousse {

/// What `controller` counted.
struct ControllerCounters {
    uint64_t items = 0;      ///< base triangles
    uint64_t displaced = 0;  ///< of these, sent into the displacement unit
    uint64_t direct = 0;     ///< sent to the triangle buffer as they are
    uint64_t bad_indices = 0;
    uint64_t overflows = 0;  ///< a direct triangle's normal left the format of `displaced_normal`
};

/// The Controller Unit (Gumhold and Huettner 2.2): reads the base triangles of a draw in order and
/// sends those that are to be displaced into the displacement unit, the others straight to the
/// triangle buffer. For each it leaves a token there, which keeps the order.
///
///  1. a descriptor: three vertex numbers and whether the triangle is `direct`; a number at or
///     above the vertex count ends the draw;
///  2. the token {number of the base triangle, route};
///  3. a direct triangle's vertices leave as they are: P' = P, N' = N in its own format.
template <class P>
class Controller {
public:
    explicit Controller(const Profile& profile)
        : to_displaced_normal_(profile.normal.frac, profile.displaced_normal) {}

    /// Starts a draw. `use_bump`: normals are wanted in the output.
    void configure(uint32_t vertex_count, bool use_bump) {
        vertex_count_ = vertex_count;
        use_bump_ = use_bump;
        next_base_ = 0;
        bad_index_ = false;
    }

    /// Steps 1 and 2 for the next base triangle. Not to be used if `bad_index()` is set after it.
    OrderToken operator()(const std::array<uint32_t, 3>& vertices, bool direct) {
        for (const uint32_t vertex : vertices) {
            if (vertex >= vertex_count_) bad_index_ = true;
        }
        ++counters_.items;
        ++(direct ? counters_.direct : counters_.displaced);
        counters_.bad_indices += bad_index_ ? 1 : 0;
        return {next_base_++, direct ? Route::Direct : Route::Displaced};
    }

    /// Step 3 for corner `part` of a direct triangle.
    SweepOutputVertex<P> undisplaced(const Vertex<P>& vertex, uint8_t part) {
        SweepOutputVertex<P> out;
        out.name = {NameKind::Corner, part, 0, 0};
        out.uv = vertex.uv;
        out.displaced = vertex.position;
        if (use_bump_) {
            out.displaced_normal = {normal(vertex.normal.x), normal(vertex.normal.y),
                                    normal(vertex.normal.z)};
        }
        return out;
    }

    bool bad_index() const { return bad_index_; }  ///< status bit, until the next draw
    const ControllerCounters& counters() const { return counters_; }

    /// The state after power-on.
    void reset() {
        configure(0, false);
        counters_ = {};
    }

private:
    typename P::Value normal(typename P::Value component) {
        return P::quantize(to_displaced_normal_, component, counters_.overflows);
    }

    Cast to_displaced_normal_;
    uint32_t vertex_count_ = 0;
    uint32_t next_base_ = 0;
    bool use_bump_ = false;
    bool bad_index_ = false;
    ControllerCounters counters_;
};

}  // namespace repousse
