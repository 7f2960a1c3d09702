#pragma once

#include <array>
#include <cstdint>

#include "datapath/items.h"
#include "datapath/numbers/policy.h"
#include "datapath/profile.h"
#include "datapath/span.h"

namespace repousse {

/// The triangles that one triangle turns into, in push order. None: it passes.
template <class P>
struct Children {
    std::array<Child<P>, 4> triangles;
    int count = 0;
};

/// What `split` counted.
struct SplitCounters {
    uint64_t items = 0;                     ///< triangles
    std::array<uint64_t, 4> edges_split{};  ///< triangles by number of split edges
    uint64_t overflows = 0;                 ///< a diagonal's component left its format
};

/// Pass or Tessellate and Tessellation (Doggett and Hirche 2.6, 3.1.5, figure 6).
///
///  1. split = (nt | sht) & vt & ct, for eligible edges; without any surface test in the scene
///     every edge counts as detailed;
///  2. a triangle without a split edge passes;
///  3. one split edge: two triangles; three: four triangles; two: the corner triangle and a quad,
///     cut along the diagonal that is shorter after displacement. The diagonal is interior to the
///     triangle, so its choice can round without ever opening an edge.
template <class P>
class Split {
public:
    using V = typename P::Value;

    explicit Split(const Profile& profile);

    /// Whether the scene has a surface test (nt or sht).
    void configure(bool has_surface_test) { has_surface_test_ = has_surface_test; }

    /// Step 1 for every edge.
    void decide(Span<Edge<P>> edges) const;

    /// Steps 2 and 3 for a triangle and its three decided edges. The children refer to both.
    void tessellate(const Triangle<P>& triangle, const Edge<P>* edges, Children<P>& children);

    const SplitCounters& counters() const { return counters_; }
    void reset() { counters_ = {}; }

private:
    bool first_diagonal_is_shorter(const Vertex<P>& a, const Vertex<P>& m1, const Vertex<P>& b,
                                   const Vertex<P>& m2);
    typename P::Wide squared_length(const Vec3<V>& p, const Vec3<V>& q);

    Cast to_diagonal_;
    bool has_surface_test_ = true;
    SplitCounters counters_;
};

}  // namespace repousse
