#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "datapath/fine_vertices.h"
#include "datapath/items.h"
#include "datapath/map_view.h"
#include "datapath/numbers/policy.h"
#include "datapath/profile.h"
#include "datapath/span.h"
#include "datapath/sweep_items.h"
#include "datapath/texel_port.h"
#include "datapath/transaction.h"
#include "datapath/units/bump_desc.h"
#include "datapath/units/normalise.h"

namespace repousse {

/// A vertex as it enters the unit: the input ports of the description.
struct BumpIn {
    Uv u;
    Vec3<int32_t> n, t;
    bool left = false;  ///< the bitangent is -(N x T)

    std::array<Word, 9> pack() const { return {u.x, u.y, n.x, n.y, n.z, t.x, t.y, t.z, left}; }
    static BumpIn unpack(const Word* w) {
        const auto vector = [](const Word* v) {
            return Vec3<int32_t>{static_cast<int32_t>(v[0]), static_cast<int32_t>(v[1]),
                                 static_cast<int32_t>(v[2])};
        };
        return {uv_from_words(w), vector(w + 2), vector(w + 5), w[8] != 0};
    }
};
static_assert(ports_are(kBumpDesc, PortKind::Input,
                        {"u_x", "u_y", "n_x", "n_y", "n_z", "t_x", "t_y", "t_z", "handedness"}));

/// The words of the map registers.
inline std::array<Word, 7> pack_bump_registers(const MapView<Fixed>& map) {
    return {map.width,
            map.height,
            map.wrap,
            map.slope_u.mantissa,
            map.slope_u.exponent,
            map.slope_v.mantissa,
            map.slope_v.exponent};
}
static_assert(ports_are(kBumpDesc, PortKind::Config,
                        {"map_width", "map_height", "wrap", "slope_u_mantissa", "slope_u_exponent",
                         "slope_v_mantissa", "slope_v_exponent"}));

/// The normals that leave it.
struct BumpOut {
    Vec3<int32_t> map_normal, displaced_normal;

    std::array<Word, 6> pack() const {
        return {map_normal.x,       map_normal.y,       map_normal.z,
                displaced_normal.x, displaced_normal.y, displaced_normal.z};
    }
};
static_assert(ports_are(kBumpDesc, PortKind::Output,
                        {"map_normal_x", "map_normal_y", "map_normal_z", "displaced_normal_x",
                         "displaced_normal_y", "displaced_normal_z"}));

/// What `bump` counted.
struct BumpCounters {
    uint64_t items = 0;              ///< normals made
    uint64_t reads = 0;              ///< texels read
    uint64_t overflows = 0;          ///< an intermediate value left its format
    uint64_t degenerate = 0;         ///< the rotated normal was zero and stays zero
    uint64_t degenerate_frames = 0;  ///< N x T was zero: N' is N
};

/// The bump mapping unit in the Tessellation Tests (Doggett and Hirche 2.1, figure 8): the normal
/// of the displaced surface, which a texel of the map says in the map's frame, rotated into the
/// vertex's.
///
///  1. read the texel at floor(U), which gives a vector D in the map's frame:
///     kind 0: the stored normal, made by finite differences on the host;
///     kind 1, Blinn: (-s_u, -s_v, 1) of the slopes, central differences of four heights;
///     kind 2, Kugler: N turned about B by a, then about T by b: (sin a, cos a sin b, cos a cos b);
///  2. B = handedness * (N x T), cast to the normal's format;
///  3. v = T Dx + B Dy + N Dz, brought to `unnormalised`;
///  4. N' = v / |v|.
///
/// Where B is zero (no tangent, or one along N) there is no frame: N' is N. A function of the
/// vertex alone, so both triangles at an edge compare the same normals.
template <class P>
class Bump {
public:
    using V = typename P::Value;

    explicit Bump(const Profile& profile);

    /// Sets the map registers; the table of the profile's kind must be there: `normals`, `heights`
    /// with the slope scales, or `turns`. The tables must outlive their use.
    void configure(const MapView<P>& map);

    /// Makes N_D and N' of a vertex that has N, T and U. Kind 1 makes no N_D: it stays zero.
    void operator()(Vertex<P>& vertex);

    /// Makes N' of a vertex of the fine mesh.
    void operator()(FineVertex<P>& vertex);

    /// One transaction of the unit.
    BumpOut operator()(const BumpIn& in);

    /// Makes N' of a batch of vertices of the fine mesh.
    void run(FineVertices<P>& batch);

    /// Makes N' of the new vertices: of every undecided edge when the normal test follows
    /// (`for_test`; of all edges when eager), else of those that are split.
    void run(Span<Edge<P>> edges, bool for_test, bool eager);

    /// Who is told of every read, in order; null: nobody. It must outlive its use.
    void attach(TexelPort* port) { port_ = port; }

    BumpKind kind() const { return kind_; }
    const BumpCounters& counters() const { return counters_; }
    void reset() { counters_ = {}; }

private:
    // Step 1, in bump_texels.cpp.
    Vec3<V> map_vector(Uv u);
    void map_vectors(const FineVertices<P>& batch, FineVectors<V>& d);
    Vec3<V> slopes(int x, int y);
    Vec3<V> turned(const Turn<typename P::Texel>& turn);
    std::size_t texel_index(int x, int y);

    /// Steps 2 to 4.
    template <class AnyVertex>
    Vec3<V> rotate(const AnyVertex& vertex, Vec3<V> d);
    void rotate(const FineVertices<P>& batch, FineVectors<V>& d, FineVectors<V>& unnormalised);

    BumpKind kind_;
    int uv_frac_;
    int d_frac_;  // fraction bits of D
    int unnormalised_bits_;
    V one_;  // in the format of D
    Format slope_;
    Cast to_normal_;
    Cast to_unnormalised_;
    Cast product_to_normal_;  // kind 2: of a sine and a cosine
    Cast normal_to_map_;      // kind 2: D as N_D
    Cast to_slope_u_, to_slope_v_;
    typename P::SinCos sin_cos_;
    Normalise<P> normalise_;
    MapView<P> map_;
    TexelPort* port_ = nullptr;
    BumpCounters counters_;
};

}  // namespace repousse
