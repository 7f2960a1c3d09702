#pragma once

#include <cstdint>

#include "datapath/items.h"
#include "datapath/map_view.h"
#include "datapath/numbers/policy.h"
#include "datapath/profile.h"
#include "datapath/span.h"
#include "datapath/sweep_items.h"
#include "datapath/units/normalise.h"

namespace repousse {

/// What `bump` counted.
struct BumpCounters {
    uint64_t items = 0;       ///< normals made
    uint64_t reads = 0;       ///< normal map texels read
    uint64_t overflows = 0;   ///< an intermediate vector left its format
    uint64_t degenerate = 0;  ///< the rotated normal was zero and stays zero
};

/// The bump mapping unit in the Tessellation Tests (Doggett and Hirche 2.1, figure 8): the map's
/// normal N_D, which was made by finite differences on the host, rotated into the vertex's frame.
///
///  1. read N_D at floor(U);
///  2. B = handedness * (N x T), cast to the normal's format;
///  3. v = T nDx + B nDy + N nDz, cast to `unnormalised`;
///  4. N' = v / |v|.
///
/// A function of the vertex alone, so both triangles at an edge compare the same normals.
template <class P>
class Bump {
public:
    using V = typename P::Value;

    explicit Bump(const Profile& profile);

    /// Sets the map registers; `map.normals` must be there. The tables must outlive their use.
    void configure(const MapView<P>& map);

    /// Reads N_D and makes N' of a vertex that has N, T and U.
    void operator()(Vertex<P>& vertex);

    /// Makes N' of a vertex of the fine mesh.
    void operator()(FineVertex<P>& vertex);

    /// Makes N' of the new vertices: of every undecided edge when the normal test follows
    /// (`for_test`; of all edges when eager), else of those that are split.
    void run(Span<Edge<P>> edges, bool for_test, bool eager);

    const BumpCounters& counters() const { return counters_; }
    void reset() { counters_ = {}; }

private:
    /// N_D at floor(u).
    Vec3<V> read(Uv u);
    template <class AnyVertex>
    Vec3<V> bitangent(const AnyVertex& vertex);
    /// Steps 2 to 4.
    template <class AnyVertex>
    Vec3<V> rotate(const AnyVertex& vertex, const Vec3<V>& map_normal);

    int uv_frac_;
    Cast to_normal_;
    Cast to_unnormalised_;
    Normalise<P> normalise_;
    MapView<P> map_;
    BumpCounters counters_;
};

}  // namespace repousse
