#include <algorithm>
#include <array>
#include <functional>
#include <map>

#include "datapath/units/bump.h"
#include "testbench/cosim/table_pool.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

using Registers = MapView<Fixed>;
using Vector = Vec3<int32_t>;
using TablePointer = std::shared_ptr<const Table>;

/// A map of texels as the read port carries them: the table has a column and a row more than the
/// map, which are not read.
TablePointer texel_map(int width, int height, const std::function<uint64_t(int, int)>& texel) {
    const auto columns = static_cast<std::size_t>(width) + 1;
    const auto table = std::make_shared<Table>(Table{width, height, {}});
    table->entries.resize(columns * (static_cast<std::size_t>(height) + 1));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            table->entries[static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x)] =
                texel(x, y);
        }
    }
    return table;
}

/// The texels of a table as the datapath reads them, of whichever kind.
struct Texels {
    std::vector<Vec3<int16_t>> normals;
    std::vector<uint16_t> heights;
    std::vector<Turn<int16_t>> turns;
};

class BumpModel : public UnitModel {
public:
    explicit BumpModel(const Profile& profile)
        : UnitModel(profile, kBumpDesc),
          kind_(static_cast<BumpKind>(profile.bump_kind)),
          unit_(profile) {}

    const UnitDesc& desc() const override { return kBumpDesc; }
    bool reads_table() const override { return true; }
    int entry_bits() const override { return fields() * field_bits(); }
    uint64_t weight() const override { return 4; }
    uint64_t icarus_weight() const override { return 10; }
    std::vector<Scenario> hard_cases() const override;
    Scenario random(Random& random, std::size_t count) const override;
    Scenario exhaustive(uint64_t portion) const override;

    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override {
        const std::vector<int64_t>& w = scenario.config;
        Registers map;
        map.width = static_cast<int>(w.at(0)), map.height = static_cast<int>(w.at(1));
        map.wrap = w.at(2) != 0;
        map.slope_u = {static_cast<int32_t>(w.at(3)), static_cast<int>(w.at(4))};
        map.slope_v = {static_cast<int32_t>(w.at(5)), static_cast<int>(w.at(6))};
        const Texels& texels = unpacked(scenario.table);
        map.normals = texels.normals, map.heights = texels.heights, map.turns = texels.turns;
        unit_.configure(map);
        outputs.clear();
        for (std::size_t i = 0; i < scenario.inputs.size(); i += inputs()) {
            const BumpOut out = unit_(BumpIn::unpack(&scenario.inputs[i]));
            for (const int64_t word : out.pack()) outputs.push_back(word);
        }
    }

    std::unique_ptr<UnitModel> with(const Profile& profile) const override {
        return make_bump_model(profile);
    }

    /// 64 different texels and 18 bits of N and T; every cast rounds and saturates.
    Profile tiny_profile() const override {
        Profile tiny = profile();
        tiny.uv.width = 5, tiny.uv.frac = 1;
        tiny.height.width = 2, tiny.height.frac = 2;
        tiny.map_normal.width = 2, tiny.map_normal.frac = 1;
        tiny.normal.width = 3, tiny.normal.frac = 1;
        tiny.unnormalised.width = 4, tiny.unnormalised.frac = 1;
        tiny.displaced_normal.width = 4, tiny.displaced_normal.frac = 2;
        tiny.slope.width = 4, tiny.slope.frac = 1;
        tiny.angle.width = 3, tiny.angle.frac = 2;
        tiny.sine_index_bits = 2;
        return tiny;
    }

private:
    /// Bits of a texel's fields, of which there are `fields`.
    int field_bits() const {
        return kind_ == BumpKind::Normals  ? profile().map_normal.width
               : kind_ == BumpKind::Slopes ? profile().height.width
                                           : profile().angle.width;
    }
    int fields() const {
        return kind_ == BumpKind::Normals ? 3 : kind_ == BumpKind::Slopes ? 1 : 2;
    }
    uint64_t texel(const std::array<int32_t, 3>& values) const {
        uint64_t word = 0;
        const uint64_t mask = (uint64_t{1} << field_bits()) - 1;
        for (int i = fields(); i-- > 0;) {
            word = word << field_bits() |
                   (static_cast<uint64_t>(values[static_cast<std::size_t>(i)]) & mask);
        }
        return word;
    }
    const Texels& unpacked(const TablePointer& pointer);
    const std::vector<TablePointer>& pool() const;
    std::array<int64_t, 7> registers(const Table& table, bool wrap, int32_t mantissa,
                                     int exponent) const {
        Registers map;
        map.width = table.width, map.height = table.height, map.wrap = wrap;
        map.slope_u = {mantissa, exponent};
        map.slope_v = {mantissa - mantissa / 3, exponent};
        return pack_bump_registers(map);
    }
    int32_t one() const { return 1 << profile().normal.frac; }
    int32_t coordinate(Random& random, int size, bool wrap) const;
    /// The nearest coordinate that a periodic map of this size accepts: within one period.
    int32_t within_a_period(int64_t u, int size) const {
        const int64_t one = int64_t{1} << profile().uv.frac;
        return limited(profile().uv, std::clamp(u, -size * one + one, (2 * size - 1) * one - one));
    }
    static int32_t limited(const Format& format, int64_t x) {
        return static_cast<int32_t>(std::clamp(x, format.min_raw(), format.max_raw()));
    }
    Vector any_vector(Random& random) const {
        const Format& format = profile().normal;
        const auto length = random.below(static_cast<uint32_t>(format.width));
        const auto any = [&] {
            if (random.percent(5))
                return limited(format, random.percent(50) ? INT64_MIN : INT64_MAX);
            return static_cast<int32_t>(random.between(format.min_raw(), format.max_raw()) >>
                                        (random.percent(80) ? length / 4 : length));
        };
        return {any(), any(), any()};
    }

    BumpKind kind_;
    Bump<Fixed> unit_;
    std::map<TablePointer, Texels> texels_;
    mutable std::vector<TablePointer> pool_;  // built when first needed
};

const Texels& BumpModel::unpacked(const TablePointer& pointer) {
    Texels& texels = texels_[pointer];
    if (!texels.normals.empty()) return texels;
    const auto width = static_cast<std::size_t>(pointer->width);
    for (std::size_t y = 0; y < static_cast<std::size_t>(pointer->height); ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            const uint64_t word = pointer->entries[y * (width + 1) + x];
            const auto field = [&](int i) {
                const int spare = 64 - field_bits();
                return static_cast<int16_t>(
                    static_cast<int64_t>(word >> (i * field_bits()) << spare) >> spare);
            };
            texels.normals.push_back({field(0), field(1), field(2)});
            texels.heights.push_back(static_cast<uint16_t>(word));
            texels.turns.push_back({field(0), field(1)});
        }
    }
    return texels;
}

const std::vector<TablePointer>& BumpModel::pool() const {
    struct Shape {
        int width, height;
    };
    constexpr std::array kShapes = {Shape{1, 1},   Shape{2, 3},    Shape{8, 8},   Shape{7, 5},
                                    Shape{64, 64}, Shape{129, 65}, Shape{1, 300}, Shape{300, 3}};
    if (!pool_.empty()) return pool_;
    Random random(1);
    const int most_texels = 1 << (profile().uv.width - 1 - profile().uv.frac);
    const uint64_t mask = (uint64_t{1} << (field_bits() * fields())) - 1;
    for (const Shape& shape : kShapes) {
        if (std::max(shape.width, shape.height) > most_texels) continue;
        pool_.push_back(
            texel_map(shape.width, shape.height, [&](int, int) { return random.next() & mask; }));
    }
    pool_.push_back(texel_map(5, 5, [&](int, int) { return mask; }));
    return pool_;
}

std::vector<Scenario> BumpModel::hard_cases() const {
    std::vector<Scenario> cases;
    const auto texel_one = static_cast<int32_t>(1 << profile().uv.frac);
    const int bits = field_bits();
    const int32_t most = (1 << (bits - 1)) - 1;  // of a field, signed
    // As kinds 0, 1 and 2 read it: normals of several lengths, the zero vector among them; heights
    // from end to end; angles from -1 to 1 half turn, the quarters among them.
    const TablePointer mixed = texel_map(4, 3, [&](int x, int y) {
        const int i = 4 * y + x;
        const std::array<int32_t, 3> normals[] = {
            {0, 0, 1 << profile().map_normal.frac}, {0, 0, 0}, {most, most, most},
            {-most - 1, -most - 1, -most - 1},      {1, 0, 0}, {0, -1, 1}};
        if (kind_ == BumpKind::Normals) return texel(normals[i % 6]);
        if (kind_ == BumpKind::Slopes) return texel({i % 3 == 2 ? 0 : (most >> i) * 2 + 1, 0, 0});
        const int32_t quarter = 1 << (bits - 2);
        return texel({quarter * (x - 2), (quarter + y) * (y - 1), 0});
    });
    const TablePointer full = texel_map(2, 2, [&](int, int) { return texel({-1, -1, -1}); });
    const TablePointer cliff = texel_map(3, 1, [&](int x, int) {
        return texel({x == 1 ? -1 : 0, x == 1 ? most : -most - 1, x == 0 ? most : 1});
    });
    const int32_t mantissa = 3 << 22;
    const int exponent = 24 + profile().height.frac - 3;  // slopes of a few units
    const auto begin = [&](const char* name, const TablePointer& table, bool wrap, int e) {
        const auto config = registers(*table, wrap, mantissa, e);
        cases.push_back({name, {config.begin(), config.end()}, table, {}});
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
    const Vector up{0, 0, one()}, east{one(), 0, 0}, zero{};

    begin("axes", mixed, false, exponent);
    every_texel(up, east);
    every_texel(east, {0, -one(), 0});
    begin("handedness", mixed, true, exponent);
    every_texel({0, one(), 0}, east);
    for (const bool wrap : {false, true}) {
        begin(wrap ? "periodic" : "clamped", mixed, wrap, exponent);
        for (const int32_t x : {-2, -1, 0, 1, 2, 3, 4, 5}) {
            for (const int32_t part : {0, texel_one - 1}) {
                const int32_t u = x * texel_one + part;
                const Uv across{u, wrap ? within_a_period(u, 3) : u};
                add(up, east, false, across);
                add(up, east, false, {across.x, texel_one});
            }
        }
    }
    begin("far_outside", mixed, false, exponent);
    for (const int64_t u : {profile().uv.min_raw(), profile().uv.max_raw()}) {
        add(up, east, false, {static_cast<int32_t>(u), 0});
        add(up, east, false, {0, static_cast<int32_t>(u)});
    }
    begin("one_texel",
          texel_map(1, 1,
                    [&](int, int) {
                        return texel({5, -7, 9});
                    }),
          true, exponent);
    add(up, east);
    begin("zero_tangent", mixed, false, exponent);  // no frame: N' is N
    every_texel(up, zero);
    every_texel({-one() / 2, one() / 3, 7}, zero);
    begin("tangent_along_the_normal", mixed, false, exponent);
    every_texel(up, up);
    every_texel(up, {0, 0, -one()});
    every_texel({one() / 2, -one() / 2, one() / 4}, {-one() / 2, one() / 2, -one() / 4});
    begin("tangent_nearly_along_the_normal", mixed, false, exponent);  // one LSB of B is a frame
    every_texel(up, {1, 0, one()});
    every_texel(up, {0, -1, -one()});
    begin("zero_normal", mixed, false, exponent);  // no direction, whatever the tangent
    every_texel(zero, east);
    every_texel(zero, zero);
    begin("short_vectors", mixed, false, exponent);
    every_texel({0, 0, 1}, {1, 0, 0});
    every_texel({1, 0, 0}, {0, one(), 0});
    const auto least = static_cast<int32_t>(profile().normal.min_raw());
    const auto highest = static_cast<int32_t>(profile().normal.max_raw());
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

/// On the map, beyond its border, near a seam, or at a texel's border.
int32_t BumpModel::coordinate(Random& random, int size, bool wrap) const {
    const int64_t one = int64_t{1} << profile().uv.frac;
    const int64_t whole = size * one;
    int64_t x = random.between(-whole / 2, whole + whole / 2);
    const uint32_t kind = random.below(100);
    if (kind < 25) x = (random.percent(50) ? 0 : whole) + random.between(-2 * one, 2 * one);
    if (kind >= 15 && kind < 40) x = (x & -one) + random.between(-1, 1);
    return wrap ? within_a_period(x, size) : limited(profile().uv, x);
}

Scenario BumpModel::random(Random& random, std::size_t count) const {
    Scenario s{"random", {}, pool()[random.below(static_cast<uint32_t>(pool().size()))], {}};
    const bool wrap = random.percent(50);
    auto mantissa = static_cast<int32_t>(random.of_any_length(kScaleBits));
    auto exponent = static_cast<int>(random.below(64));
    if (random.percent(70)) {  // slopes that neither vanish nor saturate
        mantissa |= 1 << (kScaleBits - 1);
        exponent = kScaleBits + profile().height.width - static_cast<int>(random.below(8));
    }
    const auto config = registers(*s.table, wrap, mantissa, exponent);
    s.config.assign(config.begin(), config.end());
    s.inputs.reserve(count * inputs());
    for (std::size_t i = 0; i < count; ++i) {
        BumpIn in;
        in.n = any_vector(random);
        in.t = any_vector(random);
        if (random.percent(4)) in.t = in.n;
        if (random.percent(2)) in.t = {};
        if (random.percent(2)) in.n = {};
        in.left = random.percent(50);
        in.u = {coordinate(random, s.table->width, wrap),
                coordinate(random, s.table->height, wrap)};
        s.add(in);
    }
    return s;
}

/// Every texel of a map of 8 x 8, which are all normals and all pairs of angles, times all N and T:
/// 2^24. Heights and their scales change from portion to portion.
Scenario BumpModel::exhaustive(uint64_t portion) const {
    if (portion >= 128 || profile().normal.width != 3) return {};
    Random random(7 + portion);
    Scenario s{"exhaustive", {}, nullptr, {}};
    s.table = texel_map(8, 8, [&](int x, int y) {
        const auto all = static_cast<uint64_t>(8 * y + x);
        return kind_ == BumpKind::Slopes ? random.below(1U << profile().height.width) : all;
    });
    const auto config =
        registers(*s.table, (portion & 1) != 0, static_cast<int32_t>(1 + random.below(15)),
                  static_cast<int>(random.below(6)));
    s.config.assign(config.begin(), config.end());
    s.inputs.reserve(inputs() << 17);
    for (uint64_t i = 0; i < uint64_t{1} << 17; ++i) {
        const uint64_t all = portion << 17 | i;
        const auto word = [all](unsigned place) {
            return static_cast<int32_t>(static_cast<uint32_t>(all >> place & 7) << 29) >> 29;
        };
        BumpIn in;
        in.n = {word(0), word(3), word(6)};
        in.t = {word(9), word(12), word(15)};
        in.u = {static_cast<int32_t>(2 * (all >> 18 & 7) + (all & 1)),
                static_cast<int32_t>(2 * (all >> 21 & 7) + (all >> 9 & 1))};
        in.left = (all * 0x9e3779b97f4a7c15ULL >> 63) != 0;
        s.add(in);
    }
    return s;
}

}  // namespace

std::unique_ptr<UnitModel> make_bump_model(const Profile& profile) {
    return std::make_unique<BumpModel>(profile);
}

}  // namespace repousse::cosim
