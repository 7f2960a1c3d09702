#include <algorithm>
#include <array>
#include <map>

#include "datapath/units/bump.h"
#include "testbench/cosim/bump_cases.h"
#include "testbench/cosim/map_stimuli.h"
#include "testbench/cosim/raw_words.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

using Registers = MapView<Fixed>;
using Vector = Vec3<int32_t>;
using TablePointer = std::shared_ptr<const Table>;

/// The texels of a table as the datapath reads them, of whichever kind.
struct Texels {
    std::vector<Vec3<int16_t>> normals;
    std::vector<uint16_t> heights;
    std::vector<Turn<int16_t>> turns;
};

class BumpModel : public UnitModel {
public:
    explicit BumpModel(const Profile& profile)
        : UnitModel(profile, kBumpDesc), texel_(profile), unit_(profile) {}

    const UnitDesc& desc() const override { return kBumpDesc; }
    bool reads_table() const override { return true; }
    int entry_bits() const override { return texel_.bits(); }
    uint64_t weight() const override { return 4; }
    uint64_t icarus_weight() const override { return 10; }
    std::vector<Scenario> hard_cases() const override { return bump_cases(profile()); }
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
        answer_each(scenario, outputs,
                    [this](const Word* in) { return unit_(BumpIn::unpack(in)).pack(); });
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
    const Texels& unpacked(const TablePointer& pointer);
    const std::vector<TablePointer>& pool() const;
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

    BumpTexel texel_;
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
            const auto field = [&](int i) { return texel_.field(word, i); };
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
    const uint64_t mask = texel_.mask();
    for (const Shape& shape : kShapes) {
        if (std::max(shape.width, shape.height) > most_texels) continue;
        pool_.push_back(
            texel_table(shape.width, shape.height, [&](int, int) { return random.next() & mask; }));
    }
    pool_.push_back(texel_table(5, 5, [&](int, int) { return mask; }));
    return pool_;
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
    s.config = bump_registers(*s.table, wrap, mantissa, exponent);
    s.inputs.reserve(count * inputs());
    const auto coordinate = [&](int size) {
        return map_coordinate(random, profile().uv, size, wrap, false);
    };
    for (std::size_t i = 0; i < count; ++i) {
        BumpIn in;
        in.n = any_vector(random);
        in.t = any_vector(random);
        if (random.percent(4)) in.t = in.n;
        if (random.percent(2)) in.t = {};
        if (random.percent(2)) in.n = {};
        in.left = random.percent(50);
        in.u = {coordinate(s.table->width), coordinate(s.table->height)};
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
    s.table = texel_table(8, 8, [&](int x, int y) {
        const uint64_t all = 8 * static_cast<uint64_t>(y) + static_cast<uint64_t>(x);
        return texel_.kind() == BumpKind::Slopes ? random.below(1U << profile().height.width) : all;
    });
    const auto mantissa = static_cast<int32_t>(1 + random.below(15));
    s.config =
        bump_registers(*s.table, (portion & 1) != 0, mantissa, static_cast<int>(random.below(6)));
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
