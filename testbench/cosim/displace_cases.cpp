#include "testbench/cosim/displace_cases.h"

#include <algorithm>

#include "datapath/units/displace.h"
#include "testbench/cosim/map_stimuli.h"

namespace repousse::cosim {
namespace {

/// Texels along a side of all levels from `first` to the last that there can be.
int rows_from(int first, int height) {
    int rows = 0;
    for (int level = first; level <= kMostLevels; ++level) rows += level_side(height, level);
    return rows;
}

}  // namespace

LevelledMap levelled_map(int width, int height,
                         const std::function<uint64_t(int x, int y)>& texel) {
    return {texel_table(width, rows_from(0, height) + rows_from(1, height), texel), height};
}

std::vector<Scenario> displace_cases(const Profile& profile) {
    std::vector<Scenario> cases;
    const auto one = static_cast<int32_t>(1 << profile.uv.frac);
    const auto half = one / 2;
    const auto up = static_cast<int32_t>(1 << profile.normal.frac);
    const uint64_t most_height = (uint64_t{1} << profile.height.width) - 1;
    const auto unit = static_cast<int32_t>(1 << profile.position.frac);

    MapView<Fixed> registers;
    // 1.0 for the largest height: mantissa 2^23, and as many bits down to world units.
    registers.scale_mantissa = 1 << 23;
    registers.scale_exponent = 23 + profile.height.frac;
    const auto begin = [&](const char* name, const LevelledMap& map, HeightFilter filter,
                           bool wrap) {
        registers.width = map.table->width, registers.height = map.height;
        registers.filter = filter, registers.wrap = wrap;
        const auto config = pack_displace_registers(registers);
        cases.push_back({name, {config.begin(), config.end()}, map.table, {}});
    };
    const auto at = [&](int32_t x, int32_t y) {
        cases.back().add(DisplaceIn{{0, -unit, unit}, {0, up, -up / 2}, {x, y}, {}});
    };
    const auto add = [&](const Vec3<int32_t>& p, const Vec3<int32_t>& n) {
        cases.back().add(DisplaceIn{p, n, {half, half}, {}});
    };
    const auto slope = [&](int x, int y) {
        return static_cast<uint64_t>(300 * x + 1000 * y + 7) & most_height;
    };
    const LevelledMap ramp = levelled_map(4, 3, slope);
    const LevelledMap full = levelled_map(2, 2, [&](int, int) { return most_height; });
    const LevelledMap texel = levelled_map(1, 1, [](int, int) { return uint64_t{1234}; });

    for (const HeightFilter filter : {HeightFilter::Nearest, HeightFilter::Bilinear}) {
        const bool nearest = filter == HeightFilter::Nearest;
        begin(nearest ? "nearest_clamped" : "bilinear_clamped", ramp, filter, false);
        for (const int32_t x : {-5 * one, -1, 0, half - 1, half, half + 1, one, 3 * one + half,
                                4 * one - 1, 4 * one, 9 * one}) {
            at(x, half);
            at(one + half, x);
        }
        begin(nearest ? "nearest_periodic" : "bilinear_periodic", ramp, filter, true);
        for (const int32_t x :
             {-2 * one, -one, -1, 0, half - 1, half, 3 * one - 1, 3 * one + half, 4 * one + 3}) {
            at(x, one);
            at(one / 4, within_a_period(profile.uv, x, 3));
        }
        begin(nearest ? "nearest_one_texel" : "bilinear_one_texel", texel, filter, true);
        for (const int32_t x : {0, half - 1, half, one - 1}) at(x, half);
        begin(nearest ? "nearest_all_at_the_top" : "bilinear_all_at_the_top", full, filter, false);
        for (const int32_t x : {0, 1, half, one, one + 1}) at(x, one - 1);
    }

    const auto footprint = [&](int32_t x, int32_t y, const LevelRead& read) {
        cases.back().add(DisplaceIn{{0, -unit, unit}, {0, up, -up / 2}, {x, y}, read});
    };
    for (const HeightFilter filter : {HeightFilter::Maximum, HeightFilter::Average}) {
        const bool maximum = filter == HeightFilter::Maximum;
        for (const bool wrap : {false, true}) {
            registers.has_minima = wrap;
            begin(maximum ? wrap ? "maximum_periodic" : "maximum_clamped"
                  : wrap  ? "average_periodic"
                          : "average_clamped",
                  ramp, filter, wrap);
            for (const bool back : {false, true}) {
                for (uint8_t level = 0; level < 3; ++level) {
                    const int32_t reach = std::min((one << level) / 2, 2 * one);
                    footprint(0, 0, {reach, reach, level, back});
                    footprint(4 * one, 3 * one, {reach, 0, level, back});
                    footprint(one, one, {0, reach, level, back});
                    footprint(2 * one + half, one + half, {reach, reach / 2, level, back});
                }
                footprint(2 * one, one, {3 * one, 2 * one, 2, back});
            }
        }
        begin(maximum ? "maximum_one_texel" : "average_one_texel", texel, filter, true);
        for (const int32_t x : {0, half, one}) footprint(x, half, {0, 0, 0, x == half});
        begin(maximum ? "maximum_all_at_the_top" : "average_all_at_the_top", full, filter, false);
        for (const int32_t x : {0, half, one}) footprint(x, one, {one, one, 0, x == half});
    }
    // Three and five places an axis: all apart, some on one texel, across a seam, twice around.
    // The highest of them is now here, now there.
    const auto rugged = [&](int x, int y) {
        return static_cast<uint64_t>(40503 * x + 30011 * y) & most_height;
    };
    const LevelledMap wide = levelled_map(13, 6, rugged);
    for (const int finer : {1, 2}) {
        registers.finer = finer;
        for (const bool wrap : {false, true}) {
            registers.has_minima = wrap;
            begin(finer == 1 ? wrap ? "one_finer_periodic" : "one_finer_clamped"
                  : wrap     ? "two_finer_periodic"
                             : "two_finer_clamped",
                  wide, HeightFilter::Maximum, wrap);
            for (uint8_t level = 0; level < 4; ++level) {
                const auto reach = [&](int size) {
                    return std::min((one << (level + finer)) / 2, (size - 1) * one);
                };
                footprint(7 * one, 3 * one, {reach(13), reach(6), level, level % 2 == 1});
                footprint(0, 6 * one, {reach(13), reach(6), level, false});
                footprint(12 * one + half, half, {reach(13) - 1, reach(6) / 2 + 1, level, true});
                footprint(13 * one, one, {1, 12 * one / 5, level, false});
            }
            footprint(2 * one, 5 * one, {12 * one, 5 * one, 0, false});
            for (int32_t x = 2; x < 11; ++x) {  // three or five whole texels each way
                const int32_t reach = one << (finer - 1);
                footprint(x * one, 3 * one, {reach, reach, 0, x % 2 == 1});
            }
        }
        begin(finer == 1 ? "one_finer_average" : "two_finer_average", wide, HeightFilter::Average,
              true);  // the ends alone
        footprint(7 * one, 3 * one, {2 * one, one, 0, false});
    }
    registers.finer = 0;
    registers.has_minima = false;

    begin("zero_normal", ramp, HeightFilter::Bilinear, false);  // not displaced
    add({unit, 2 * unit, -3 * unit}, {0, 0, 0});

    begin("position_saturates", full, HeightFilter::Nearest, false);
    const auto most = static_cast<int32_t>(profile.position.max_raw());
    add({most, -most - 1, most}, {up, -up, -up});
    add({most, -most - 1, 0}, {1, -1, up});

    registers.scale_exponent = 0;  // far beyond the format
    begin("displacement_saturates", full, HeightFilter::Bilinear, false);
    add({0, unit, -unit}, {up, -up, up / 3});
    registers.scale_exponent = 63;  // nothing is left
    registers.bias = static_cast<int32_t>(profile.displacement.min_raw());
    begin("largest_exponent", full, HeightFilter::Bilinear, false);
    add({0, unit, -unit}, {up, -up, up / 3});
    registers.scale_exponent = 0;
    registers.bias = static_cast<int32_t>(profile.displacement.max_raw());
    begin("bias_saturates", full, HeightFilter::Nearest, false);
    add({0, unit, -unit}, {up, -up, up / 3});
    registers.scale_mantissa = (1 << 24) - 1;
    registers.scale_exponent = 40;
    registers.bias = -1;
    begin("negative_bias", ramp, HeightFilter::Bilinear, false);
    for (const int32_t x : {one, one + 3, 2 * one - 1}) at(x, x / 2);
    return cases;
}

}  // namespace repousse::cosim
