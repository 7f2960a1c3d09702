#include "datapath/units/height_test.h"

#include <algorithm>
#include <limits>
#include <string>

namespace repousse {
namespace {

/// The largest map, and with it the longest edge: its box around U12 is 2048 x 2048, so that an
/// area fits 23 bits and two of them 24.
constexpr int kMaxSize = 1 << (kMapSizeBits - 1);
constexpr int kAreaBits = 2 * kMapSizeBits - 3;

/// Both products of the Average mode must stay below the 64th bit: a sum of sat_width bits (two of
/// them: one more) times the areas above, and threshold * A12 * (A1 + A2).
constexpr int kMaxSatWidth = 63 - kAreaBits - 1;
constexpr int kMaxHeightBits = 63 - kAreaBits - (kAreaBits + 1);

int32_t absolute(int32_t x) { return x < 0 ? -x : x; }

}  // namespace

HeightTest::HeightTest(const Profile& profile)
    : frac_(profile.uv.frac),
      height_bits_(profile.height.width),
      sat_width_(profile.sat_width),
      sat_mask_((uint64_t(1) << profile.sat_width) - 1) {}

Status HeightTest::check(const HeightTestRegisters& r, std::size_t table_entries) const {
    const auto refuse = [](const char* key, std::string what, std::string expected) {
        return Status(Error{ErrorKind::Input, key, std::move(what), std::move(expected), {}});
    };
    if (sat_width_ > kMaxSatWidth) {
        return refuse("sat_width", std::to_string(sat_width_) + " bits overflow the products",
                      "at most " + std::to_string(kMaxSatWidth));
    }
    if (height_bits_ > kMaxHeightBits) {
        return refuse("height", std::to_string(height_bits_) + " bits overflow the products",
                      "at most " + std::to_string(kMaxHeightBits));
    }
    if (r.width < 1 || r.width > kMaxSize || r.height < 1 || r.height > kMaxSize) {
        return refuse("map", std::to_string(r.width) + " x " + std::to_string(r.height) + " texels",
                      "1 to " + std::to_string(kMaxSize) + " a side");
    }
    const auto entries =
        static_cast<std::size_t>(r.width + 1) * static_cast<std::size_t>(r.height + 1);
    if (table_entries != entries) {
        return refuse("map", "a summed-area table of " + std::to_string(table_entries) + " entries",
                      std::to_string(entries) + ", which is (width + 1) * (height + 1)");
    }
    const uint64_t most =
        r.mode == HeightMode::Average ? (uint64_t(1) << height_bits_) - 1 : sat_mask_;
    if (r.threshold > most) {
        return refuse("threshold", std::to_string(r.threshold) + " is out of range",
                      "0 to " + std::to_string(most));
    }
    return done();
}

void HeightTest::configure(const HeightTestRegisters& registers, Span<const uint64_t> table) {
    registers_ = registers;
    table_ = table;

    // A box around U12 is at most ceil(e/2) texels wide, those around the ends ceil(e/4). Twice
    // the two ends' sums must fit as well, so that SUM's difference is exact in one bit more.
    const uint64_t highest = (uint64_t(1) << height_bits_) - 1;
    const auto holds = [&](int edge, int parts, uint64_t boxes) {
        const int side = (edge + parts - 1) / parts;
        const int w = registers.wrap ? side : std::min(side, registers.width);
        const int h = registers.wrap ? side : std::min(side, registers.height);
        return boxes * static_cast<uint64_t>(w) * static_cast<uint64_t>(h) * highest <= sat_mask_;
    };
    const int most = registers.wrap
                         ? std::min(kMaxSize, 2 * std::min(registers.width, registers.height))
                         : kMaxSize;
    max_edge_ = 0;
    for (int step = kMaxSize; step > 0; step /= 2) {
        const int edge = max_edge_ + step;
        if (edge <= most && holds(edge, 2, 1) && holds(edge, 4, 4)) max_edge_ = edge;
    }
    max_extent_ = max_edge_ << frac_;

    // Corners lie at most half a period (max_edge / 4) from U: they stay within [-W, 2W].
    constexpr int32_t kAnywhere = std::numeric_limits<int32_t>::max();
    const auto half = [&](int size) { return (size << frac_) >> 1; };
    low_ = registers.wrap ? Uv{-half(registers.width), -half(registers.height)}
                          : Uv{-kAnywhere, -kAnywhere};
    high_ = registers.wrap ? Uv{3 * half(registers.width), 3 * half(registers.height)}
                           : Uv{kAnywhere, kAnywhere};
}

bool HeightTest::accepts(Uv u1, Uv u2, Uv u12) const {
    const auto inside = [this](Uv u) {
        return (u.x >= low_.x) & (u.x <= high_.x) & (u.y >= low_.y) & (u.y <= high_.y);
    };
    const bool is_short =
        (absolute(u1.x - u2.x) <= max_extent_) & (absolute(u1.y - u2.y) <= max_extent_);
    return is_short & inside(u1) & inside(u2) & inside(u12);
}

/// Brings a coordinate within one period of the map into [0, size) and returns its period, q.
/// (2 * size becomes size, the table's last column: just as right.)
int32_t HeightTest::reduce(int32_t& x, int32_t size) {
    const int32_t q = int32_t(x >= size) - int32_t(x < 0);
    x -= q * size;
    return q;
}

HeightTest::Side HeightTest::side(int32_t centre, int32_t half, int32_t size) const {
    Side s;
    s.lo = (centre - half) >> frac_;
    s.hi = (centre + half) >> frac_;
    if (!registers_.wrap) {
        s.lo = std::max(0, std::min(s.lo, size));
        s.hi = std::max(0, std::min(s.hi, size));
    }
    if (registers_.mode == HeightMode::Average && s.lo == s.hi) {
        // One texel, so that the average exists: the next one, or the last one of a clamped map.
        const bool at_end = !registers_.wrap && s.lo == size;
        s.lo -= at_end;
        s.hi = s.lo + 1;
    }
    s.texels = s.hi - s.lo;
    if (registers_.wrap) s.seam = reduce(s.lo, size) != reduce(s.hi, size);
    return s;
}

HeightTest::Box HeightTest::box(Uv centre, int32_t half_x, int32_t half_y) const {
    return {side(centre.x, half_x, registers_.width), side(centre.y, half_y, registers_.height)};
}

HeightTest::Boxes HeightTest::boxes(Uv u1, Uv u2, Uv u12) const {
    int32_t x = absolute(u1.x - u2.x);
    int32_t y = absolute(u1.y - u2.y);
    if (registers_.box == BoxKind::Square) x = y = std::max(x, y);
    return {box(u1, x >> 3, y >> 3), box(u2, x >> 3, y >> 3), box(u12, x >> 2, y >> 2)};
}

/// T(hi, y) - T(lo, y), and one T(W, y) if the box crosses a vertical seam.
uint64_t HeightTest::row(int32_t y, const Side& x) const {
    const uint64_t* entries = table_.data() + static_cast<std::size_t>(y) *
                                                  static_cast<std::size_t>(registers_.width + 1);
    const uint64_t inner = entries[x.hi] - entries[x.lo];
    return x.seam ? inner + entries[registers_.width] : inner;
}

/// Equation 2 in arithmetic modulo 2^sat_width, exact because the true sum is smaller than that.
uint64_t HeightTest::sum(const Box& box) const {
    uint64_t total = row(box.y.hi, box.x) - row(box.y.lo, box.x);
    if (box.y.seam) total += row(registers_.height, box.x);
    return total & sat_mask_;
}

/// |S12/A12 - S/A| > threshold with both sides multiplied by A12 * A. Widths at 4096 x 4096 with
/// 16-bit heights: S12 and S 38 bits, A12 and A at most 2^22, so products of at most 61 bits.
bool HeightTest::differ_in_average(uint64_t mid, uint64_t mid_area, uint64_t ends,
                                   uint64_t ends_area) const {
    const uint64_t a = mid * ends_area;
    const uint64_t b = ends * mid_area;
    return (a < b ? b - a : a - b) > registers_.threshold * (mid_area * ends_area);
}

/// |S12 - 2 (S1 + S2)| > 2 threshold. The difference lies within +-2^sat_width, so one bit more
/// than the table stores holds it with its sign; it is taken modulo that width, as hardware does.
bool HeightTest::differ_in_sum(uint64_t mid, uint64_t ends) const {
    const int spare = 63 - sat_width_;
    const int64_t difference = static_cast<int64_t>((mid - 2 * ends) << spare) >> spare;
    const auto magnitude = static_cast<uint64_t>(difference < 0 ? -difference : difference);
    return magnitude > 2 * registers_.threshold;
}

// In the order of the hardware: a beat for each row (high, low, last) and column (likewise), in it
// the boxes around U1, U2, U12 that have such an entry.
void HeightTest::announce(const Boxes& at) const {
    const auto entry = [](int number, const Side& side, int32_t last) {
        return number == 0 ? side.hi : number == 1 ? side.lo : last;
    };
    const auto wanted = [](int number, const Side& side) { return number < 2 || side.seam; };
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            for (const Box* box : {&at.end1, &at.end2, &at.mid}) {
                if (!wanted(row, box->y) || !wanted(column, box->x)) continue;
                const auto y = static_cast<uint32_t>(entry(row, box->y, registers_.height));
                const auto x = static_cast<uint32_t>(entry(column, box->x, registers_.width));
                port_->read(y * static_cast<uint32_t>(registers_.width + 1) + x);
            }
        }
    }
}

bool HeightTest::operator()(Uv u1, Uv u2, Uv u12, HeightTestStats& stats) const {
    if (!accepts(u1, u2, u12)) {
        ++stats.refused;
        return false;
    }
    const Boxes at = boxes(u1, u2, u12);
    stats.reads += static_cast<uint64_t>(at.entries());
    stats.beats += static_cast<uint64_t>(at.beats());
    if (port_ != nullptr) announce(at);

    const uint64_t ends = (sum(at.end1) + sum(at.end2)) & sat_mask_;
    return registers_.mode == HeightMode::Average
               ? differ_in_average(sum(at.mid), at.mid.area(), ends,
                                   at.end1.area() + at.end2.area())
               : differ_in_sum(sum(at.mid), ends);
}

HeightTest::Reads HeightTest::reads(Uv u1, Uv u2, Uv u12) const {
    const Boxes at = boxes(u1, u2, u12);
    return {{at.end1.reads(), at.end2.reads(), at.mid.reads()}, at.beats()};
}

}  // namespace repousse
