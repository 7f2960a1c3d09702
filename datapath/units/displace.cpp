#include "datapath/units/displace.h"

#include <algorithm>

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
    finer_ = map.filter == HeightFilter::Maximum ? map.finer : 0;
    for (int level = 0; level <= map.last_level; ++level) {
        const auto l = static_cast<std::size_t>(level);
        start_[0][l] = level_start(map, level);
        start_[1][l] = level_start(map, level, map.has_minima);
        row_[l] = static_cast<std::size_t>(level_side(map.width, level));
    }
    // Height LSB times mantissa times 2^-exponent is in world units.
    to_displacement_ = Cast(filter_bits_ + map.scale_exponent, displacement_format_);
}

template <class P>
typename P::Wide Displace<P>::nearest(Uv u) {
    const int x = texel_address(u.x >> uv_frac_, map_.width, map_.wrap);
    const int y = texel_address(u.y >> uv_frac_, map_.height, map_.wrap);
    return P::align(P::exact(texel(x, y), 0), filter_bits_);
}

// Texel centres lie at +1/2, so the cell is found half a texel lower.
template <class P>
typename P::Wide Displace<P>::bilinear(Uv u) {
    const int32_t half = int32_t{1} << uv_frac_ >> 1;
    const int x = (u.x - half) >> uv_frac_;
    const int y = (u.y - half) >> uv_frac_;
    const int left = texel_address(x, map_.width, map_.wrap);
    const int right = texel_address(x + 1, map_.width, map_.wrap);
    const int low = texel_address(y, map_.height, map_.wrap);
    const int high = texel_address(y + 1, map_.height, map_.wrap);
    // One after the other, in the order of the read port.
    const uint32_t left_low = texel(left, low);
    const uint32_t right_low = texel(right, low);
    const uint32_t left_high = texel(left, high);
    const uint32_t right_high = texel(right, high);
    return P::quantize(
        to_filtered_,
        P::exact(between(left_low, right_low, left_high, right_high, u.x - half, u.y - half),
                 2 * uv_frac_),
        counters_.overflows);
}

// 2^finer + 1 places from U - reach to U + reach, with spaces between them of no more than a texel
// of the level that `footprint` asks for. Each is brought onto the map, then to the level; one that
// touches a texel that another has touched adds nothing. A level's last texel may be cut short by
// the border of a periodic map, and stepped over. Sums have one bit more than `uv`.
template <class P>
typename Displace<P>::Touched Displace<P>::touched(int32_t u, int32_t reach, int level,
                                                   int size) const {
    const auto coordinate = [&](int64_t place) {
        return texel_address(static_cast<int>(place >> uv_frac_), size, map_.wrap) >> level;
    };
    Touched touched;
    const auto look = [&](int64_t place) {
        const int at = coordinate(place);
        const auto end = touched.at.begin() + touched.count;
        if (std::find(touched.at.begin(), end, at) == end) {
            touched.at[static_cast<std::size_t>(touched.count++)] = at;
        }
    };
    const int64_t middle = u, halfway = reach >> 1;
    touched.at[0] = coordinate(middle - reach);
    if (finer_ == 2) look(middle - halfway);
    if (finer_ >= 1) look(middle);
    if (finer_ == 2) look(middle + halfway);
    look(middle + reach);
    return touched;
}

// Where both ends of an axis touch one texel, an average, which is a sum of four quarters, counts
// it twice.
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

template class Displace<Fixed>;
template class Displace<Real>;

}  // namespace repousse
