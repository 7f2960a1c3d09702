#pragma once

#include <array>
#include <cstdint>

#include "datapath/items.h"
#include "datapath/map_view.h"
#include "datapath/numbers/policy.h"
#include "datapath/profile.h"
#include "datapath/span.h"
#include "datapath/transaction.h"
#include "datapath/units/displace_desc.h"

namespace repousse {

/// A vertex as it enters the unit: the input ports of the description.
struct DisplaceIn {
    Vec3<int32_t> p, n;
    Uv u;

    std::array<Word, 8> pack() const { return {p.x, p.y, p.z, n.x, n.y, n.z, u.x, u.y}; }
    static DisplaceIn unpack(const Word* w) {
        const auto vector = [](const Word* v) {
            return Vec3<int32_t>{static_cast<int32_t>(v[0]), static_cast<int32_t>(v[1]),
                                 static_cast<int32_t>(v[2])};
        };
        return {vector(w), vector(w + 3), uv_from_words(w + 6)};
    }
};
static_assert(ports_are(kDisplaceDesc, PortKind::Input,
                        {"p_x", "p_y", "p_z", "n_x", "n_y", "n_z", "u_x", "u_y"}));

/// The words of the map registers.
inline std::array<Word, 7> pack_displace_registers(const MapView<Fixed>& map) {
    return {map.width,          map.height,         map.wrap, map.filter == HeightFilter::Bilinear,
            map.scale_mantissa, map.scale_exponent, map.bias};
}
static_assert(ports_are(kDisplaceDesc, PortKind::Config,
                        {"map_width", "map_height", "wrap", "bilinear", "scale_mantissa",
                         "scale_exponent", "bias"}));

/// The vertex that leaves it.
struct DisplaceOut {
    Vec3<int32_t> displaced;

    std::array<Word, 3> pack() const { return {displaced.x, displaced.y, displaced.z}; }
};
static_assert(ports_are(kDisplaceDesc, PortKind::Output,
                        {"displaced_x", "displaced_y", "displaced_z"}));

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
