#pragma once

#include <cstdint>

#include "datapath/items.h"
#include "datapath/numbers/policy.h"
#include "datapath/profile.h"
#include "datapath/span.h"
#include "datapath/units/normalise.h"

namespace repousse {

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
