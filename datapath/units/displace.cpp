#include "datapath/units/displace.h"

namespace repousse {

template <class P>
Displace<P>::Displace(const Profile& profile)
    : uv_frac_(profile.uv.frac),
      filter_bits_(profile.filtered_height.frac - profile.height.frac),
      align_position_(profile.displacement.frac + profile.normal.frac - profile.position.frac),
      displacement_format_(profile.displacement),
      to_filtered_(profile.height.frac + 2 * profile.uv.frac, profile.filtered_height),
      average_to_filtered_(profile.height.frac + 2, profile.filtered_height),
      add_bias_(profile.displacement.frac, profile.displacement),
      to_position_(profile.displacement.frac + profile.normal.frac, profile.position) {}

template <class P>
void Displace<P>::configure(const MapView<P>& map) {
    map_ = map;
    for (int level = 0; level <= map.last_level; ++level) {
        const auto l = static_cast<std::size_t>(level);
        start_[0][l] = level_start(map, level);
        start_[1][l] = level_start(map, level, map.has_minima);
        row_[l] = static_cast<std::size_t>(level_side(map.width, level));
    }
    // Height LSB times mantissa times 2^-exponent is in world units.
    to_displacement_ = Cast(filter_bits_ + map.scale_exponent, displacement_format_);
}

// Coordinates of the level, on it.
template <class P>
int64_t Displace<P>::texel(int x, int y, int level, bool minima) {
    ++counters_.reads;
    const auto l = static_cast<std::size_t>(level);
    const std::size_t place =
        start_[minima][l] + static_cast<std::size_t>(y) * row_[l] + static_cast<std::size_t>(x);
    if (port_ != nullptr) port_->read(static_cast<uint32_t>(place));
    return map_.heights[place];
}

template <class P>
typename P::Wide Displace<P>::nearest(Uv u) {
    const int x = texel_address(u.x >> uv_frac_, map_.width, map_.wrap);
    const int y = texel_address(u.y >> uv_frac_, map_.height, map_.wrap);
    return P::align(P::exact(texel(x, y), 0), filter_bits_);
}

// Texel centres lie at +1/2, so the cell is found half a texel lower. The weights have F bits
// each and sum to 2^F: 16 + 2 F <= 48 bits, exact.
template <class P>
typename P::Wide Displace<P>::bilinear(Uv u) {
    const int32_t one = int32_t(1) << uv_frac_;
    const int32_t half = one >> 1;
    const int x = (u.x - half) >> uv_frac_;
    const int y = (u.y - half) >> uv_frac_;
    const int left = texel_address(x, map_.width, map_.wrap);
    const int right = texel_address(x + 1, map_.width, map_.wrap);
    const int low = texel_address(y, map_.height, map_.wrap);
    const int high = texel_address(y + 1, map_.height, map_.wrap);
    const int64_t fx = (u.x - half) & (one - 1);
    const int64_t fy = (u.y - half) & (one - 1);
    // One after the other, in the order of the read port.
    const int64_t left_low = texel(left, low);
    const int64_t right_low = texel(right, low);
    const int64_t left_high = texel(left, high);
    const int64_t right_high = texel(right, high);
    const int64_t lower = left_low * (one - fx) + right_low * fx;
    const int64_t upper = left_high * (one - fx) + right_high * fx;
    return P::quantize(to_filtered_, P::exact(lower * (one - fy) + upper * fy, 2 * uv_frac_),
                       counters_.overflows);
}

// The ends of U +- reach, brought onto the map, then to the level: a level's last texel may be cut
// short by the border of a periodic map. Sums have one bit more than `uv`.
template <class P>
typename Displace<P>::Touched Displace<P>::touched(int32_t u, int32_t reach, int level,
                                                   int size) const {
    const auto end = [&](int64_t at) {
        return texel_address(static_cast<int>(at >> uv_frac_), size, map_.wrap) >> level;
    };
    Touched touched;
    touched.at = {end(int64_t{u} - reach), end(int64_t{u} + reach)};
    touched.count = touched.at[0] == touched.at[1] ? 1 : 2;
    return touched;
}

// Where both ends of an axis touch one texel, it is read once; an average, which is a sum of four
// quarters, counts it twice.
template <class P>
typename P::Wide Displace<P>::of_level(Uv u, const LevelRead& read) {
    const Touched columns = touched(u.x, read.reach_x, read.level, map_.width);
    const Touched rows = touched(u.y, read.reach_y, read.level, map_.height);
    int64_t sum = 0, most = 0, least = INT64_MAX;
    for (int j = 0; j < rows.count; ++j) {
        for (int i = 0; i < columns.count; ++i) {
            const int64_t h = texel(columns.at[static_cast<std::size_t>(i)],
                                    rows.at[static_cast<std::size_t>(j)], read.level, read.back);
            sum += h;
            most = h > most ? h : most;
            least = h < least ? h : least;
        }
    }
    if (map_.filter == HeightFilter::Maximum) {
        return P::align(P::exact(read.back ? least : most, 0), filter_bits_);
    }
    const int64_t quarters = sum * (4 / (rows.count * columns.count));
    return P::quantize(average_to_filtered_, P::exact(quarters, 2), counters_.overflows);
}

template <class P>
typename P::Wide Displace<P>::height(Uv u, const LevelRead& read) {
    if (reads_levels(map_.filter)) return of_level(u, read);
    return map_.filter == HeightFilter::Bilinear ? bilinear(u) : nearest(u);
}

template <class P>
typename P::Value Displace<P>::displacement(Uv u, const LevelRead& read) {
    const V scaled = P::quantize(to_displacement_, P::mul(height(u, read), map_.scale_mantissa),
                                 counters_.overflows);
    return P::quantize(add_bias_, typename P::Wide(scaled) + map_.bias, counters_.overflows);
}

template <class P>
Vec3<typename P::Value> Displace<P>::operator()(const Vec3<V>& p, const Vec3<V>& n, Uv u,
                                                const LevelRead& read) {
    ++counters_.items;
    const V d = displacement(u, read);
    const auto displaced = [&](V position, V normal) {
        return P::quantize(to_position_, P::align(position, align_position_) + P::mul(d, normal),
                           counters_.overflows);
    };
    return {displaced(p.x, n.x), displaced(p.y, n.y), displaced(p.z, n.z)};
}

template <class P>
void Displace<P>::run(Span<Edge<P>> edges) {
    for (Edge<P>& edge : edges) {
        if (!edge.split) continue;
        edge.mid.displaced = (*this)(edge.mid.position, edge.mid.normal, edge.mid.uv);
    }
}

// ---- batches of fine vertices -------------------------------------------------------------------

// Texels are read in the order of the vertices.
template <class P>
void Displace<P>::run(FineVertices<P>& b) {
    counters_.items += b.size;
    const bool levels = reads_levels(map_.filter);
    FineArray<typename P::Wide> heights;
    for (std::size_t i = 0; i < b.size; ++i) {
        heights[i] = height(b.uv(i), levels ? b.reads[i] : LevelRead{});
    }
    move(b, heights);
}

namespace {

template <class P>
struct DisplaceCasts {
    const Cast &to_displacement, &add_bias, &to_position;
    typename P::Value mantissa, bias;
    int align_position;
};

template <class P>
inline void move_all(FineVertices<P>& b, const FineArray<typename P::Wide>& heights,
                     const DisplaceCasts<P>& c, uint64_t& overflows) {
    using Wide = typename P::Wide;
    const Wide mantissa = c.mantissa, bias = c.bias;
    const int align = c.align_position;
    FineArray<typename P::Value> scaled, d;
    P::quantize(c.to_displacement, b.size, scaled.data(), overflows,
                [&](std::size_t i) { return P::mul(heights[i], mantissa); });
    P::quantize(c.add_bias, b.size, d.data(), overflows,
                [&](std::size_t i) { return Wide(scaled[i]) + bias; });
    const auto component = [&](const auto& position, const auto& normal, auto& to) {
        P::quantize(c.to_position, b.size, to.data(), overflows, [&](std::size_t i) {
            return P::align(position[i], align) + P::mul(d[i], normal[i]);
        });
    };
    component(b.position.x, b.normal.x, b.displaced.x);
    component(b.position.y, b.normal.y, b.displaced.y);
    component(b.position.z, b.normal.z, b.displaced.z);
}

}  // namespace

template <>
REPOUSSE_VECTOR_CLONES void Displace<Fixed>::move(FineVertices<Fixed>& b,
                                                  const FineArray<Fixed::Wide>& heights) {
    move_all<Fixed>(b, heights,
                    {to_displacement_, add_bias_, to_position_, map_.scale_mantissa, map_.bias,
                     align_position_},
                    counters_.overflows);
}

template <>
void Displace<Real>::move(FineVertices<Real>& b, const FineArray<Real::Wide>& heights) {
    move_all<Real>(b, heights,
                   {to_displacement_, add_bias_, to_position_, map_.scale_mantissa, map_.bias,
                    align_position_},
                   counters_.overflows);
}

template class Displace<Fixed>;
template class Displace<Real>;

}  // namespace repousse
