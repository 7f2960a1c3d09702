#include <algorithm>
#include <array>
#include <map>

#include "datapath/units/displace.h"
#include "testbench/cosim/displace_cases.h"
#include "testbench/cosim/map_stimuli.h"
#include "testbench/cosim/raw_words.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

using Registers = MapView<Fixed>;
using TablePointer = std::shared_ptr<const Table>;

Registers unpack_registers(const std::vector<int64_t>& w) {
    Registers map;
    map.width = static_cast<int>(w.at(0));
    map.height = static_cast<int>(w.at(1));
    map.wrap = w.at(2) != 0;
    map.filter = static_cast<HeightFilter>(w.at(3));
    map.finer = static_cast<int>(w.at(4));
    map.has_minima = w.at(5) != 0;
    map.last_level = kMostLevels;
    map.scale_mantissa = static_cast<int32_t>(w.at(6));
    map.scale_exponent = static_cast<int>(w.at(7));
    map.bias = static_cast<int32_t>(w.at(8));
    return map;
}

class DisplaceModel : public UnitModel {
public:
    explicit DisplaceModel(const Profile& profile)
        : UnitModel(profile, kDisplaceDesc), unit_(profile) {}

    const UnitDesc& desc() const override { return kDisplaceDesc; }
    bool reads_table() const override { return true; }
    uint64_t weight() const override { return 4; }
    std::vector<Scenario> hard_cases() const override { return displace_cases(profile()); }
    Scenario random(Random& random, std::size_t count) const override;
    Scenario exhaustive(uint64_t portion) const override;

    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override {
        Registers map = unpack_registers(scenario.config);
        map.heights = texels(scenario.table, map.height);
        unit_.configure(map);
        answer_each(scenario, outputs, [this](const Word* words) {
            const DisplaceIn in = DisplaceIn::unpack(words);
            return DisplaceOut{unit_(in.p, in.n, in.u, in.read)}.pack();
        });
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

    const std::vector<LevelledMap>& pool() const;
    /// A reach that the unit accepts, within one period of the map.
    int32_t reach(Random& random, int size) const;
    uint64_t most_height() const { return (uint64_t{1} << profile().height.width) - 1; }

    Displace<Fixed> unit_;
    std::map<TablePointer, std::vector<uint16_t>> texels_;
    mutable std::vector<LevelledMap> pool_;  // built when first needed
};

const std::vector<LevelledMap>& DisplaceModel::pool() const {
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
        pool_.push_back(levelled_map(shape.width, shape.height,
                                     [&](int, int) { return random.next() & most_height(); }));
    }
    pool_.push_back(levelled_map(5, 5, [&](int, int) { return most_height(); }));
    return pool_;
}

int32_t DisplaceModel::reach(Random& random, int size) const {
    const int64_t most = int64_t{size - 1} << profile().uv.frac;
    const int64_t any = static_cast<int64_t>(random.of_any_length(profile().uv.width - 1));
    return limited(profile().uv, std::min(any, most));
}

Scenario DisplaceModel::random(Random& random, std::size_t count) const {
    const LevelledMap& map = pool()[random.below(static_cast<uint32_t>(pool().size()))];
    Scenario s{"random", {}, map.table, {}};
    Registers registers;
    registers.width = s.table->width;
    registers.height = map.height;
    registers.wrap = random.percent(50);
    registers.filter = static_cast<HeightFilter>(random.below(4));
    registers.finer = static_cast<int>(random.below(kMostFiner + 1));
    registers.has_minima = random.percent(50);
    registers.scale_mantissa = static_cast<int32_t>(random.of_any_length(kScaleBits));
    registers.scale_exponent = static_cast<int>(random.below(64));
    if (random.percent(70)) {  // some world units, neither nothing nor too much
        registers.scale_mantissa |= 1 << (kScaleBits - 1);
        registers.scale_exponent =
            kScaleBits + profile().height.frac - static_cast<int>(random.below(12));
    }
    registers.bias = random.percent(30) ? 0 : any_raw(random, profile().displacement);
    const auto config = pack_displace_registers(registers);
    s.config.assign(config.begin(), config.end());

    s.inputs.reserve(count * inputs());
    for (std::size_t i = 0; i < count; ++i) {
        DisplaceIn in;
        for (int32_t* p : {&in.p.x, &in.p.y, &in.p.z}) *p = any_raw(random, profile().position);
        for (int32_t* n : {&in.n.x, &in.n.y, &in.n.z}) *n = any_raw(random, profile().normal);
        in.u = {map_coordinate(random, profile().uv, registers.width, registers.wrap, true),
                map_coordinate(random, profile().uv, registers.height, registers.wrap, true)};
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
/// scales. Filter levels: U on the map, every reach along x, every level that such a map has, every
/// `finer` (three or two of the scales each), and both sides, for one P and N.
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
    registers.finer = static_cast<int>(portion >> 5 & 7) % (kMostFiner + 1);
    registers.has_minima = (portion >> 5 & 1) != 0;
    registers.width = shape.width, registers.height = shape.height;
    registers.scale_mantissa = scale.mantissa;
    registers.scale_exponent = scale.exponent;
    registers.bias = scale.bias;
    const auto config = pack_displace_registers(registers);
    Random random(7 + portion);
    Scenario s{"exhaustive", {config.begin(), config.end()}, nullptr, {}};
    s.table = levelled_map(shape.width, shape.height, [&](int, int) {
                  return random.below(1U << profile().height.width);
              }).table;
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
                in.u = {within_a_period(profile().uv, in.u.x, shape.width),
                        within_a_period(profile().uv, in.u.y, shape.height)};
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
