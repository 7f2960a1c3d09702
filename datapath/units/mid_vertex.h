#pragma once

#include <array>
#include <cstdint>

#include "datapath/items.h"
#include "datapath/numbers/policy.h"
#include "datapath/profile.h"
#include "datapath/span.h"
#include "datapath/transaction.h"
#include "datapath/units/mid_vertex_desc.h"
#include "datapath/units/normalise.h"

namespace repousse {

/// One end of an edge as it enters the unit, and the midpoint as it leaves.
struct MidVertexEnd {
    Uv u;
    uint8_t generation = 0;  ///< of an end 0 to 14
    Vec3<int32_t> p, n, t;
    bool left = false;  ///< the bitangent is -(N x T)

    std::array<Word, 13> pack() const {
        return {u.x, u.y, generation, p.x, p.y, p.z, n.x, n.y, n.z, t.x, t.y, t.z, left};
    }
    static MidVertexEnd unpack(const Word* w) {
        const auto vector = [](const Word* v) {
            return Vec3<int32_t>{static_cast<int32_t>(v[0]), static_cast<int32_t>(v[1]),
                                 static_cast<int32_t>(v[2])};
        };
        return {uv_from_words(w), static_cast<uint8_t>(w[2]),
                vector(w + 3),    vector(w + 6),
                vector(w + 9),    w[12] != 0};
    }
};

/// An edge as it enters the unit: the input ports of the description.
struct MidVertexIn {
    std::array<MidVertexEnd, 2> ends;

    std::array<Word, 26> pack() const {
        std::array<Word, 26> words{};
        std::size_t at = 0;
        for (const MidVertexEnd& end : ends) {
            for (const Word word : end.pack()) words[at++] = word;
        }
        return words;
    }
    static MidVertexIn unpack(const Word* w) {
        return {{MidVertexEnd::unpack(w), MidVertexEnd::unpack(w + 13)}};
    }
};
static_assert(ports_are(kMidVertexDesc, PortKind::Input,
                        {"u1_x", "u1_y",        "generation1", "p1_x", "p1_y", "p1_z",  "n1_x",
                         "n1_y", "n1_z",        "t1_x",        "t1_y", "t1_z", "left1", "u2_x",
                         "u2_y", "generation2", "p2_x",        "p2_y", "p2_z", "n2_x",  "n2_y",
                         "n2_z", "t2_x",        "t2_y",        "t2_z", "left2"}));
static_assert(ports_are(kMidVertexDesc, PortKind::Output,
                        {"u12_x", "u12_y", "generation12", "p12_x", "p12_y", "p12_z", "n12_x",
                         "n12_y", "n12_z", "t12_x", "t12_y", "t12_z", "left12"}));

/// What `mid_vertex` counted.
struct MidVertexCounters {
    uint64_t items = 0;       ///< midpoints made
    uint64_t attributes = 0;  ///< of these, with position, normal and tangent
    uint64_t overflows = 0;   ///< a sum of normals left its format
    uint64_t degenerate = 0;  ///< two opposite normals or tangents: the mean has no direction
};

/// Calculate New U, New P and New N (Doggett and Hirche 2.1, 3.1.2, 3.1.4): the vertex half-way
/// between the ends of an edge.
///
///  1. U = (U1 + U2) >> 1, exact and the same from both sides; generation = max + 1;
///  2. P = (P1 + P2) / 2;
///  3. N = normalise(N1 + N2), T = normalise(T1 + T2).
///
/// Step 1 comes before the cheap tests, steps 2 and 3 only where something still needs them.
template <class P>
class MidVertex {
public:
    using V = typename P::Value;

    explicit MidVertex(const Profile& profile);
    MidVertex(const MidVertex&) = delete;
    MidVertex& operator=(const MidVertex&) = delete;

    /// Step 1: texture coordinates and generation of `mid`.
    void topology(const Vertex<P>& v1, const Vertex<P>& v2, Vertex<P>& mid);

    /// Steps 2 and 3. Opposite vectors give the zero vector, symmetric in both ends.
    void attributes(const Vertex<P>& v1, const Vertex<P>& v2, Vertex<P>& mid);

    /// One transaction of the unit: all three steps.
    MidVertexEnd operator()(const MidVertexIn& in);

    /// Step 1 for every edge.
    void run_topology(Span<Edge<P>> edges);

    /// Steps 2 and 3: for every undecided edge when the normal test follows (`for_test`; for all
    /// edges when eager), else for those that are split.
    void run_attributes(Span<Edge<P>> edges, bool for_test, bool eager);

    const MidVertexCounters& counters() const { return counters_; }
    void reset() { counters_ = {}; }

private:
    Vec3<V> mean_direction(const Vec3<V>& a, const Vec3<V>& b);

    int align_sum_;  // to the fraction of `unnormalised`, so that the cast only clamps
    Cast to_unnormalised_;
    Normalise<P> normalise_;
    MidVertexCounters counters_;
};

}  // namespace repousse
