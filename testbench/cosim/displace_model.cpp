#include <algorithm>
#include <array>
#include <map>

#include "datapath/units/displace.h"
#include "testbench/cosim/table_pool.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

using Registers = MapView<Fixed>;
using TablePointer = std::shared_ptr<const Table>;

/// Texels along a side of all levels from `first` to the last that there can be.
int rows_from(int first, int height) {
    int rows = 0;
    for (int level = first; level <= kMostLevels; ++level) rows += level_side(height, level);
    return rows;
}

/// A map of heights with its levels, which stand below each other, then the minima of levels 1 and
/// up. Their texels are what `texel` says of the rows further down: no level of this map, but the
/// unit cannot know. The table has a column and a row more, which are not read.
TablePointer height_map(int width, int height, const std::function<uint64_t(int, int)>& texel) {
    const auto columns = static_cast<std::size_t>(width) + 1;
    const int rows = rows_from(0, height) + rows_from(1, height);
    const auto table = std::make_shared<Table>(Table{width, rows, {}});
    table->entries.resize(columns * (static_cast<std::size_t>(rows) + 1));
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < width; ++x) {
            table->entries[static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x)] =
                texel(x, y);
        }
    }
    return table;
}

Registers unpack_registers(const std::vector<int64_t>& w) {
    Registers map;
    map.width = static_cast<int>(w.at(0));
    map.height = static_cast<int>(w.at(1));
    map.wrap = w.at(2) != 0;
    map.filter = static_cast<HeightFilter>(w.at(3));
    map.has_minima = w.at(4) != 0;
    map.last_level = kMostLevels;
    map.scale_mantissa = static_cast<int32_t>(w.at(5));
    map.scale_exponent = static_cast<int>(w.at(6));
    map.bias = static_cast<int32_t>(w.at(7));
    return map;
}

/// A map that a scenario may use: its table, and its own rows in it.
struct Map {
    TablePointer table;
    int height = 0;
};

class DisplaceModel : public UnitModel {
public:
    explicit DisplaceModel(const Profile& profile)
        : UnitModel(profile, kDisplaceDesc), unit_(profile) {}

    const UnitDesc& desc() const override { return kDisplaceDesc; }
    bool reads_table() const override { return true; }
    uint64_t weight() const override { return 4; }
    std::vector<Scenario> hard_cases() const override;
    Scenario random(Random& random, std::size_t count) const override;
    Scenario exhaustive(uint64_t portion) const override;

    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override {
        Registers map = unpack_registers(scenario.config);
        map.heights = texels(scenario.table, map.height);
        unit_.configure(map);
        outputs.clear();
        for (std::size_t i = 0; i < scenario.inputs.size(); i += inputs()) {
            const DisplaceIn in = DisplaceIn::unpack(&scenario.inputs[i]);
            const DisplaceOut out{unit_(in.p, in.n, in.u, in.read)};
            for (const int64_t word : out.pack()) outputs.push_back(word);
        }
    }

    std::unique_ptr<UnitModel> with(const Profile& profile) const override {
        return make_displace_model(profile);
    }

    /// s2.2 coordinates on maps of up to 3 x 3 texels of two bits; every cast rounds and saturates.
    Profile tiny_profile() const override {
        Profile tiny = profile();
        tiny.uv.width = 5, tiny.uv.frac = 2;
        tiny.height.width = 2, tiny.height.frac = 2;
        tiny.filtered_height.width = 4, tiny.filtered_height.frac = 4;
        tiny.displacement.width = 5, tiny.displacement.frac = 2;
        tiny.position.width = 5, tiny.position.frac = 2;
        tiny.normal.width = 3, tiny.normal.frac = 1;
        return tiny;
    }

private:
    /// The heights as the datapath reads them: no more columns than a level has.
    Span<const uint16_t> texels(const TablePointer& pointer, int map_height) {
        std::vector<uint16_t>& heights = texels_[pointer];
        if (!heights.empty()) return heights;
        const auto columns = static_cast<std::size_t>(pointer->width) + 1;
        const uint64_t* row = pointer->entries.data();
        for (const int first : {0, 1}) {
            for (int level = first; level <= kMostLevels; ++level) {
                for (int y = 0; y < level_side(map_height, level); ++y, row += columns) {
                    heights.insert(heights.end(), row, row + level_side(pointer->width, level));
                }
            }
        }
        return heights;
    }

    const std::vector<Map>& pool() const;
    /// A reach that the unit accepts, within one period of the map.
    int32_t reach(Random& random, int size) const;
    int32_t coordinate(Random& random, int size, bool wrap) const;
    /// The nearest coordinate that a periodic map of this size accepts: within one period.
    int32_t within_a_period(int64_t u, int size) const {
        const int64_t one = int64_t{1} << profile().uv.frac;
        return limited(profile().uv, std::clamp(u, -size * one + one, (2 * size - 1) * one - one));
    }
    static int32_t limited(const Format& format, int64_t x) {
        return static_cast<int32_t>(std::clamp(x, format.min_raw(), format.max_raw()));
    }
    static int32_t any(Random& random, const Format& format) {
        if (random.percent(5)) return limited(format, random.percent(50) ? INT64_MIN : INT64_MAX);
        return static_cast<int32_t>(random.between(format.min_raw(), format.max_raw()) >>
                                    random.below(static_cast<uint32_t>(format.width)));
    }
    uint64_t most_height() const { return (uint64_t{1} << profile().height.width) - 1; }

    Displace<Fixed> unit_;
    std::map<TablePointer, std::vector<uint16_t>> texels_;
    mutable std::vector<Map> pool_;  // built when first needed
};

const std::vector<Map>& DisplaceModel::pool() const {
    struct Shape {
        int width, height;
    };
    constexpr std::array kShapes = {Shape{1, 1},   Shape{2, 3},     Shape{8, 8},    Shape{7, 5},
                                    Shape{64, 64}, Shape{257, 129}, Shape{1, 1024}, Shape{1024, 3}};
    if (!pool_.empty()) return pool_;
    Random random(1);
    const int most_texels = 1 << (profile().uv.width - 1 - profile().uv.frac);
    for (const Shape& shape : kShapes) {
        if (std::max(shape.width, shape.height) > most_texels) continue;
        pool_.push_back({height_map(shape.width, shape.height,
                                    [&](int, int) { return random.next() & most_height(); }),
                         shape.height});
    }
    pool_.push_back({height_map(5, 5, [&](int, int) { return most_height(); }), 5});
    return pool_;
}

std::vector<Scenario> DisplaceModel::hard_cases() const {
    std::vector<Scenario> cases;
    const auto one = static_cast<int32_t>(1 << profile().uv.frac);
    const auto half = one / 2;
    const auto up = static_cast<int32_t>(1 << profile().normal.frac);
    const auto unit = static_cast<int32_t>(1 << profile().position.frac);

    Registers registers;
    // 1.0 for the largest height: mantissa 2^23, and as many bits down to world units.
    registers.scale_mantissa = 1 << 23;
    registers.scale_exponent = 23 + profile().height.frac;
    const auto begin = [&](const char* name, const Map& map, HeightFilter filter, bool wrap) {
        const TablePointer& table = map.table;
        registers.width = table->width, registers.height = map.height;
        registers.filter = filter, registers.wrap = wrap;
        const auto config = pack_displace_registers(registers);
        cases.push_back({name, {config.begin(), config.end()}, table, {}});
    };
    const auto at = [&](int32_t x, int32_t y) {
        cases.back().add(DisplaceIn{{0, -unit, unit}, {0, up, -up / 2}, {x, y}, {}});
    };
    const auto add = [&](const Vec3<int32_t>& p, const Vec3<int32_t>& n) {
        cases.back().add(DisplaceIn{p, n, {half, half}, {}});
    };
    const auto slope = [&](int x, int y) {
        return static_cast<uint64_t>(300 * x + 1000 * y + 7) & most_height();
    };
    const Map ramp{height_map(4, 3, slope), 3};
    const Map full{height_map(2, 2, [&](int, int) { return most_height(); }), 2};
    const Map texel{height_map(1, 1, [](int, int) { return uint64_t{1234}; }), 1};

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
            at(one / 4, within_a_period(x, 3));
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
    registers.has_minima = false;

    begin("zero_normal", ramp, HeightFilter::Bilinear, false);  // not displaced
    add({unit, 2 * unit, -3 * unit}, {0, 0, 0});

    begin("position_saturates", full, HeightFilter::Nearest, false);
    const auto most = static_cast<int32_t>(profile().position.max_raw());
    add({most, -most - 1, most}, {up, -up, -up});
    add({most, -most - 1, 0}, {1, -1, up});

    registers.scale_exponent = 0;  // far beyond the format
    begin("displacement_saturates", full, HeightFilter::Bilinear, false);
    add({0, unit, -unit}, {up, -up, up / 3});
    registers.scale_exponent = 63;  // nothing is left
    registers.bias = static_cast<int32_t>(profile().displacement.min_raw());
    begin("largest_exponent", full, HeightFilter::Bilinear, false);
    add({0, unit, -unit}, {up, -up, up / 3});
    registers.scale_exponent = 0;
    registers.bias = static_cast<int32_t>(profile().displacement.max_raw());
    begin("bias_saturates", full, HeightFilter::Nearest, false);
    add({0, unit, -unit}, {up, -up, up / 3});
    registers.scale_mantissa = (1 << 24) - 1;
    registers.scale_exponent = 40;
    registers.bias = -1;
    begin("negative_bias", ramp, HeightFilter::Bilinear, false);
    for (const int32_t x : {one, one + 3, 2 * one - 1}) at(x, x / 2);
    return cases;
}

/// On the map, beyond its border, near a seam, or at a texel's border or centre.
int32_t DisplaceModel::coordinate(Random& random, int size, bool wrap) const {
    const int64_t one = int64_t{1} << profile().uv.frac;
    const int64_t whole = size * one;
    int64_t x = random.between(-whole / 2, whole + whole / 2);
    const uint32_t kind = random.below(100);
    if (kind < 25) x = (random.percent(50) ? 0 : whole) + random.between(-2 * one, 2 * one);
    if (kind >= 15 && kind < 40) x = (x & -one) + random.between(-1, 1);
    if (kind >= 40 && kind < 60) x = (x & -one) + one / 2 + random.between(-1, 1);
    return wrap ? within_a_period(x, size) : limited(profile().uv, x);
}

int32_t DisplaceModel::reach(Random& random, int size) const {
    const int64_t most = int64_t{size - 1} << profile().uv.frac;
    const int64_t any = static_cast<int64_t>(random.of_any_length(profile().uv.width - 1));
    return limited(profile().uv, std::min(any, most));
}

Scenario DisplaceModel::random(Random& random, std::size_t count) const {
    const Map& map = pool()[random.below(static_cast<uint32_t>(pool().size()))];
    Scenario s{"random", {}, map.table, {}};
    Registers registers;
    registers.width = s.table->width;
    registers.height = map.height;
    registers.wrap = random.percent(50);
    registers.filter = static_cast<HeightFilter>(random.below(4));
    registers.has_minima = random.percent(50);
    registers.scale_mantissa = static_cast<int32_t>(random.of_any_length(kScaleBits));
    registers.scale_exponent = static_cast<int>(random.below(64));
    if (random.percent(70)) {  // some world units, neither nothing nor too much
        registers.scale_mantissa |= 1 << (kScaleBits - 1);
        registers.scale_exponent =
            kScaleBits + profile().height.frac - static_cast<int>(random.below(12));
    }
    registers.bias = random.percent(30) ? 0 : any(random, profile().displacement);
    const auto config = pack_displace_registers(registers);
    s.config.assign(config.begin(), config.end());

    s.inputs.reserve(count * inputs());
    for (std::size_t i = 0; i < count; ++i) {
        DisplaceIn in;
        for (int32_t* p : {&in.p.x, &in.p.y, &in.p.z}) *p = any(random, profile().position);
        for (int32_t* n : {&in.n.x, &in.n.y, &in.n.z}) *n = any(random, profile().normal);
        in.u = {coordinate(random, registers.width, registers.wrap),
                coordinate(random, registers.height, registers.wrap)};
        in.read = {reach(random, registers.width), reach(random, registers.height),
                   static_cast<uint8_t>(random.below(kMostLevels + 1)), random.percent(50)};
        if (reads_levels(registers.filter)) {
            // A footprint adds its reach to what must lie within a period.
            const auto on_map = [&](int32_t u, int size) {
                return static_cast<int32_t>(std::clamp<int64_t>(
                    u, 0,
                    std::min<int64_t>(int64_t{size} << profile().uv.frac, profile().uv.max_raw())));
            };
            in.u = {on_map(in.u.x, registers.width), on_map(in.u.y, registers.height)};
        }
        s.add(in);
    }
    return s;
}

/// U, one component of P and one of N, for the four filters, both borders, four maps and eight
/// scales. Filter levels: U on the map, every reach along x, every level that such a map has, and
/// both sides, for one P and N.
Scenario DisplaceModel::exhaustive(uint64_t portion) const {
    struct Shape {
        int width, height;
    };
    constexpr std::array kShapes = {Shape{1, 1}, Shape{2, 2}, Shape{3, 3}, Shape{2, 3}};
    struct Scale {
        int mantissa, exponent, bias;
    };
    constexpr std::array kScales = {Scale{1, 0, 0},   Scale{3, 2, -3}, Scale{5, 1, 1},
                                    Scale{7, 5, -16}, Scale{9, 3, 15}, Scale{31, 4, -7},
                                    Scale{3, 7, 2},   Scale{13, 3, 0}};
    const Shape shape = kShapes[portion >> 3 & 3];
    const Scale scale = kScales[portion >> 5 & 7];
    if (portion >= 256) return {};
    Registers registers;
    registers.wrap = (portion & 1) != 0;
    registers.filter = static_cast<HeightFilter>(portion >> 1 & 3);
    registers.has_minima = (portion >> 5 & 1) != 0;
    registers.width = shape.width, registers.height = shape.height;
    registers.scale_mantissa = scale.mantissa;
    registers.scale_exponent = scale.exponent;
    registers.bias = scale.bias;
    const auto config = pack_displace_registers(registers);
    Random random(7 + portion);
    Scenario s{"exhaustive", {config.begin(), config.end()}, nullptr, {}};
    s.table = height_map(shape.width, shape.height,
                         [&](int, int) { return random.below(1U << profile().height.width); });
    for (uint64_t i = 0; i < uint64_t{1} << 17; ++i) {
        const auto field = [i](int place, int width) {
            return static_cast<int32_t>(i >> place & ((1U << width) - 1));
        };
        const auto word = [&](int place, int width) {
            return field(place, width) - (1 << (width - 1));
        };
        DisplaceIn in;
        if (reads_levels(registers.filter)) {
            in.u = {std::min(field(0, 4), 4 * shape.width),
                    std::min(field(4, 4), 4 * shape.height)};
            in.read = {std::min(field(8, 4), 4 * (shape.width - 1)),
                       std::min(3 * field(15, 2), 4 * (shape.height - 1)),
                       static_cast<uint8_t>(field(12, 2)), field(14, 1) != 0};
            in.p = {5, -3, 0}, in.n = {1, -2, 3};
        } else {
            in.u = {word(0, 5), word(5, 5)};
            if (registers.wrap) {
                in.u = {within_a_period(in.u.x, shape.width),
                        within_a_period(in.u.y, shape.height)};
            }
            in.p.x = word(10, 4), in.n.x = word(14, 3);
            in.p.y = ~in.p.x, in.n.y = in.n.x;
            in.p.z = in.p.x, in.n.z = ~in.n.x;
        }
        s.add(in);
    }
    return s;
}

}  // namespace

std::unique_ptr<UnitModel> make_displace_model(const Profile& profile) {
    return std::make_unique<DisplaceModel>(profile);
}

}  // namespace repousse::cosim
