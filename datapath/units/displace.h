#pragma once

#include <cstdint>

#include "datapath/items.h"
#include "datapath/map_view.h"
#include "datapath/numbers/policy.h"
#include "datapath/profile.h"
#include "datapath/span.h"

namespace repousse {

/// What `displace` counted.
struct DisplaceCounters {
    uint64_t items = 0;      ///< vertices displaced
    uint64_t reads = 0;      ///< texels read
    uint64_t overflows = 0;  ///< D or P' left its format
};

/// Displace Vertex (Doggett and Hirche, equation 1 and section 3): P' = P + D(U) N.
///
///  1. read one texel, or four around U for a bilinear height;
///  2. interpolate them with the fraction of U (exact: 16 + 2 F bits) and cast once;
///  3. scale to world units and add the bias;
///  4. one multiply-add a component.
///
/// A function of the vertex alone, so both triangles at an edge make the same point.
template <class P>
class Displace {
public:
    using V = typename P::Value;

    explicit Displace(const Profile& profile);

    /// Sets the map registers. The tables must outlive their use.
    void configure(const MapView<P>& map);

    /// P' for a vertex with base position p, unit normal n (zero: not displaced) and texel
    /// coordinates u within one period of the map.
    Vec3<V> operator()(const Vec3<V>& p, const Vec3<V>& n, Uv u);

    /// D(u) in world units.
    V displacement(Uv u);

    /// Displaces the new vertex of every edge that is split.
    void run(Span<Edge<P>> edges);

    const DisplaceCounters& counters() const { return counters_; }
    void reset() { counters_ = {}; }

private:
    typename P::Wide bilinear(Uv u);
    int64_t texel(int x, int y) const;

    int uv_frac_;
    int filter_bits_;     // extra fraction bits of a filtered height over a stored one
    int align_position_;  // from the position's fraction to that of D * N
    Format displacement_format_;
    Cast to_filtered_;
    Cast to_displacement_;
    Cast add_bias_;
    Cast to_position_;
    MapView<P> map_;
    DisplaceCounters counters_;
};

}  // namespace repousse
