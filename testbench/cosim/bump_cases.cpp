#include "testbench/cosim/bump_cases.h"

#include "testbench/cosim/map_stimuli.h"

namespace repousse::cosim {

using Vector = Vec3<int32_t>;

BumpTexel::BumpTexel(const Profile& profile)
    : kind_(static_cast<BumpKind>(profile.bump_kind)),
      fields_(kind_ == BumpKind::Normals  ? 3
              : kind_ == BumpKind::Slopes ? 1
                                          : 2),
      field_bits_(kind_ == BumpKind::Normals  ? profile.map_normal.width
                  : kind_ == BumpKind::Slopes ? profile.height.width
                                              : profile.angle.width) {}

uint64_t BumpTexel::word(const std::array<int32_t, 3>& values) const {
    uint64_t word = 0;
    const uint64_t mask = (uint64_t{1} << field_bits_) - 1;
    for (int i = fields_; i-- > 0;) {
        word = word << field_bits_ |
               (static_cast<uint64_t>(values[static_cast<std::size_t>(i)]) & mask);
    }
    return word;
}

int16_t BumpTexel::field(uint64_t word, int i) const {
    const int spare = 64 - field_bits_;
    return static_cast<int16_t>(static_cast<int64_t>(word >> (i * field_bits_) << spare) >> spare);
}

std::vector<int64_t> bump_registers(const Table& table, bool wrap, int32_t mantissa, int exponent) {
    MapView<Fixed> map;
    map.width = table.width, map.height = table.height, map.wrap = wrap;
    map.slope_u = {mantissa, exponent};
    map.slope_v = {mantissa - mantissa / 3, exponent};
    const auto words = pack_bump_registers(map);
    return {words.begin(), words.end()};
}

std::vector<Scenario> bump_cases(const Profile& profile) {
    std::vector<Scenario> cases;
    const int32_t one = 1 << profile.normal.frac;
    const auto texel_one = static_cast<int32_t>(1 << profile.uv.frac);
    const BumpTexel kind(profile);
    const auto texel = [&kind](const std::array<int32_t, 3>& values) { return kind.word(values); };
    const int bits = kind.field_bits();
    const int32_t most = (1 << (bits - 1)) - 1;  // of a field, signed
    // As kinds 0, 1 and 2 read it: normals of several lengths, the zero vector among them; heights
    // from end to end; angles from -1 to 1 half turn, the quarters among them.
    const std::shared_ptr<const Table> mixed = texel_table(4, 3, [&](int x, int y) {
        const int i = 4 * y + x;
        const std::array<int32_t, 3> normals[] = {
            {0, 0, 1 << profile.map_normal.frac}, {0, 0, 0}, {most, most, most},
            {-most - 1, -most - 1, -most - 1},    {1, 0, 0}, {0, -1, 1}};
        if (kind.kind() == BumpKind::Normals) return texel(normals[i % 6]);
        if (kind.kind() == BumpKind::Slopes)
            return texel({i % 3 == 2 ? 0 : (most >> i) * 2 + 1, 0, 0});
        const int32_t quarter = 1 << (bits - 2);
        return texel({quarter * (x - 2), (quarter + y) * (y - 1), 0});
    });
    const std::shared_ptr<const Table> full = texel_table(2, 2, [&](int, int) {
        return texel({-1, -1, -1});
    });
    const std::shared_ptr<const Table> cliff = texel_table(3, 1, [&](int x, int) {
        return texel({x == 1 ? -1 : 0, x == 1 ? most : -most - 1, x == 0 ? most : 1});
    });
    const int32_t mantissa = 3 << 22;
    const int exponent = 24 + profile.height.frac - 3;  // slopes of a few units
    const auto begin = [&](const char* name, const std::shared_ptr<const Table>& table, bool wrap,
                           int e) {
        cases.push_back({name, bump_registers(*table, wrap, mantissa, e), table, {}});
    };
    const auto add = [&](const Vector& n, const Vector& t, bool left = false, Uv u = {}) {
        cases.back().add(BumpIn{u, n, t, left});
    };
    const auto every_texel = [&](const Vector& n, const Vector& t) {
        for (int y = 0; y < cases.back().table->height; ++y) {
            for (int x = 0; x < cases.back().table->width; ++x) {
                for (const bool left : {false, true}) {
                    add(n, t, left, {x * texel_one + texel_one / 2, y * texel_one});
                }
            }
        }
    };
    const Vector up{0, 0, one}, east{one, 0, 0}, zero{};

    begin("axes", mixed, false, exponent);
    every_texel(up, east);
    every_texel(east, {0, -one, 0});
    begin("handedness", mixed, true, exponent);
    every_texel({0, one, 0}, east);
    for (const bool wrap : {false, true}) {
        begin(wrap ? "periodic" : "clamped", mixed, wrap, exponent);
        for (const int32_t x : {-2, -1, 0, 1, 2, 3, 4, 5}) {
            for (const int32_t part : {0, texel_one - 1}) {
                const int32_t u = x * texel_one + part;
                const Uv across{u, wrap ? within_a_period(profile.uv, u, 3) : u};
                add(up, east, false, across);
                add(up, east, false, {across.x, texel_one});
            }
        }
    }
    begin("far_outside", mixed, false, exponent);
    for (const int64_t u : {profile.uv.min_raw(), profile.uv.max_raw()}) {
        add(up, east, false, {static_cast<int32_t>(u), 0});
        add(up, east, false, {0, static_cast<int32_t>(u)});
    }
    begin("one_texel",
          texel_table(1, 1,
                      [&](int, int) {
                          return texel({5, -7, 9});
                      }),
          true, exponent);
    add(up, east);
    begin("zero_tangent", mixed, false, exponent);  // no frame: N' is N
    every_texel(up, zero);
    every_texel({-one / 2, one / 3, 7}, zero);
    begin("tangent_along_the_normal", mixed, false, exponent);
    every_texel(up, up);
    every_texel(up, {0, 0, -one});
    every_texel({one / 2, -one / 2, one / 4}, {-one / 2, one / 2, -one / 4});
    begin("tangent_nearly_along_the_normal", mixed, false, exponent);  // one LSB of B is a frame
    every_texel(up, {1, 0, one});
    every_texel(up, {0, -1, -one});
    begin("zero_normal", mixed, false, exponent);  // no direction, whatever the tangent
    every_texel(zero, east);
    every_texel(zero, zero);
    begin("short_vectors", mixed, false, exponent);
    every_texel({0, 0, 1}, {1, 0, 0});
    every_texel({1, 0, 0}, {0, one, 0});
    const auto least = static_cast<int32_t>(profile.normal.min_raw());
    const auto highest = static_cast<int32_t>(profile.normal.max_raw());
    begin("longest_vectors", mixed, false, exponent);  // B and v saturate, but for kind 1's v
    every_texel({least, least, highest}, {least, highest, highest});
    every_texel({least, highest, least}, {highest, least, least});
    every_texel({highest, highest, highest}, {highest, highest, -highest});
    begin("all_at_the_top", full, false, exponent);
    every_texel(up, east);
    begin("cliff", cliff, true, exponent);
    every_texel(up, east);
    begin("slopes_saturate", mixed, false, 0);
    every_texel(up, east);
    every_texel({least, least, least}, {highest, least, highest});
    begin("largest_exponent", mixed, false, 63);  // nothing is left of the slopes
    every_texel(up, east);
    return cases;
}

}  // namespace repousse::cosim
