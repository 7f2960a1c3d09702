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
#include "datapath/texel_port.h"
#include "datapath/transaction.h"
#include "datapath/units/displace_desc.h"

namespace repousse {

/// A vertex as it enters the unit: the input ports of the description.
struct DisplaceIn {
    Vec3<int32_t> p, n;
    Uv u;
    LevelRead read;

    std::array<Word, 12> pack() const {
        return {p.x, p.y, p.z,          n.x,          n.y,        n.z,
                u.x, u.y, read.reach_x, read.reach_y, read.level, read.back};
    }
    static DisplaceIn unpack(const Word* w) {
        const auto vector = [](const Word* v) {
            return Vec3<int32_t>{static_cast<int32_t>(v[0]), static_cast<int32_t>(v[1]),
                                 static_cast<int32_t>(v[2])};
        };
        return {vector(w),
                vector(w + 3),
                uv_from_words(w + 6),
                {static_cast<int32_t>(w[8]), static_cast<int32_t>(w[9]),
                 static_cast<uint8_t>(w[10]), w[11] != 0}};
    }
};
static_assert(ports_are(kDisplaceDesc, PortKind::Input,
                        {"p_x", "p_y", "p_z", "n_x", "n_y", "n_z", "u_x", "u_y", "reach_x",
                         "reach_y", "level", "back"}));

/// The words of the map registers.
inline std::array<Word, 9> pack_displace_registers(const MapView<Fixed>& map) {
    return {map.width, map.height,     map.wrap,           static_cast<Word>(map.filter),
            map.finer, map.has_minima, map.scale_mantissa, map.scale_exponent,
            map.bias};
}
static_assert(ports_are(kDisplaceDesc, PortKind::Config,
                        {"map_width", "map_height", "wrap", "filter", "finer", "minima",
                         "scale_mantissa", "scale_exponent", "bias"}));

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
///  1. read one texel, or four around U for a bilinear height; or, of a filter level, those under
///     the corners of a footprint, each once (Gumhold and Huettner 4.1); of a level that is `finer`
///     all under 2^finer + 1 places along each axis, row by row, each once;
///  2. interpolate them with the fraction of U (exact: 16 + 2 F bits) and cast once; or take the
///     highest, the lowest where the surface is seen from the back, or the average;
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
    /// `read` is looked at by the filters that read levels.
    Vec3<V> operator()(const Vec3<V>& p, const Vec3<V>& n, Uv u, const LevelRead& read = {});

    /// D(u) in world units.
    V displacement(Uv u, const LevelRead& read = {});

    /// Displaces a batch of vertices that have position, normal and texel coordinates.
    void run(FineVertices<P>& batch);

    /// Displaces the new vertex of every edge that is split.
    void run(Span<Edge<P>> edges);

    /// Who is told of every read, in order; null: nobody. It must outlive its use.
    void attach(TexelPort* port) { port_ = port; }

    const DisplaceCounters& counters() const { return counters_; }
    void reset() { counters_ = {}; }

private:
    /// Coordinates of the level's texels that a footprint touches along one axis, each once.
    struct Touched {
        std::array<int, kMostPlaces> at{};
        int count = 1;  ///< the first place touches one
    };

    typename P::Wide height(Uv u, const LevelRead& read);
    typename P::Wide nearest(Uv u);
    typename P::Wide bilinear(Uv u);
    typename P::Wide of_level(Uv u, const LevelRead& read);
    Touched touched(int32_t u, int32_t reach, int level, int size) const;
    /// Reads a texel; coordinates of the level, on it.
    uint16_t texel(int x, int y, int level = 0, bool minima = false) {
        ++counters_.reads;
        const auto l = static_cast<std::size_t>(level);
        const std::size_t place =
            start_[minima][l] + static_cast<std::size_t>(y) * row_[l] + static_cast<std::size_t>(x);
        if (port_ != nullptr) port_->read(static_cast<uint32_t>(place));
        return map_.heights[place];
    }

    // Batches, in displace_batch.cpp.
    struct Cells;
    void heights(const FineVertices<P>& batch, FineArray<V>& to);
    void read(const FineVertices<P>& batch, Cells& cells);
    void interpolate(const FineVertices<P>& batch, const Cells& cells, FineArray<V>& to);
    void move(FineVertices<P>& batch, const FineArray<V>& heights);

    /// A height between four texels, times 2^(2 F). Weights are the F <= 16 lowest bits of x and y,
    /// and what they lack to 2^F: 32 bits a row, 48 in all, exact.
    int64_t between(uint32_t left_low, uint32_t right_low, uint32_t left_high, uint32_t right_high,
                    int32_t x, int32_t y) const {
        const uint32_t one = uint32_t{1} << uv_frac_;
        const uint32_t fx = static_cast<uint32_t>(x) & (one - 1);
        const uint32_t fy = static_cast<uint32_t>(y) & (one - 1);
        const uint32_t lower = left_low * (one - fx) + right_low * fx;
        const uint32_t upper = left_high * (one - fx) + right_high * fx;
        return static_cast<int64_t>(uint64_t{lower} * (one - fy) + uint64_t{upper} * fy);
    }

    int uv_frac_;
    int filter_bits_;     // extra fraction bits of a filtered height over a stored one
    int align_position_;  // from the position's fraction to that of D * N
    Format displacement_format_;
    Cast to_filtered_, average_to_filtered_;
    Cast to_displacement_;
    Cast add_bias_;
    Cast to_position_;
    MapView<P> map_;
    int finer_ = 0;  // of the maximum alone: an average is a sum of quarters
    TexelPort* port_ = nullptr;
    /// First texels of the levels, then of their minima; and texels in a row of each.
    std::array<std::array<std::size_t, kMostLevels + 1>, 2> start_{};
    std::array<std::size_t, kMostLevels + 1> row_{};
    DisplaceCounters counters_;
};

}  // namespace repousse
