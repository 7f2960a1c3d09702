#include <algorithm>
#include <array>

#include "datapath/units/height_test.h"
#include "testbench/cosim/height_test_cases.h"
#include "testbench/cosim/raw_words.h"
#include "testbench/cosim/table_pool.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

class HeightTestModel : public UnitModel {
public:
    explicit HeightTestModel(const Profile& profile)
        : UnitModel(profile, kHeightTestDesc), unit_(profile) {}

    const UnitDesc& desc() const override { return kHeightTestDesc; }
    bool reads_table() const override { return true; }
    std::vector<Scenario> hard_cases() const override { return height_test_cases(profile()); }
    Scenario random(Random& random, std::size_t count) const override;
    Scenario exhaustive(uint64_t portion) const override;

    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override {
        unit_.configure(unpack_registers(scenario.config), scenario.table->entries);
        HeightTestStats stats;
        answer_each(scenario, outputs,
                    [&](const Word* in) { return unit_(HeightTestIn::unpack(in), stats).pack(); });
    }

    std::unique_ptr<UnitModel> with(const Profile& profile) const override {
        return make_height_test_model(profile);
    }

    /// s2.1 coordinates on maps of up to 3 x 3 texels of two bits.
    Profile tiny_profile() const override {
        Profile tiny = profile();
        tiny.uv.width = 4;
        tiny.uv.frac = 1;
        tiny.height.width = 2;
        tiny.height.frac = 0;
        tiny.sat_width = 8;
        return tiny;
    }

private:
    const std::vector<std::shared_ptr<const Table>>& pool() const {
        if (pool_.empty()) {
            const int texels = 1 << std::min(12, profile().uv.width - 1 - profile().uv.frac);
            pool_ = table_pool(texels, profile().height.width, profile().sat_width);
        }
        return pool_;
    }
    uint64_t max_threshold(HeightMode mode) const {
        const int bits = mode == HeightMode::Average ? profile().height.width : profile().sat_width;
        return (uint64_t{1} << bits) - 1;
    }
    Uv position(Random& random, const HeightTestRegisters& registers) const;
    int32_t coordinate(Random& random, int size, bool wrap) const;
    Uv other_end(Random& random, Uv u1, int max_edge) const;
    int32_t clamp(int64_t x) const { return limited(profile().uv, x); }

    HeightTest unit_;
    mutable std::vector<std::shared_ptr<const Table>> pool_;  // built when first needed
};

/// On the map, outside of it, near a seam, or at a texel's border.
int32_t HeightTestModel::coordinate(Random& random, int size, bool wrap) const {
    const int64_t one = int64_t{1} << profile().uv.frac;
    const int64_t whole = size * one;
    const int64_t outside = wrap ? whole / 2 : whole / 4;
    int64_t x = random.between(-outside, whole + outside);
    const uint32_t kind = random.below(100);
    if (kind < 25) x = (random.percent(50) ? 0 : whole) + random.between(-2 * one, 2 * one);
    if (kind >= 15 && kind < 45) x = (x & -one) + random.between(-1, 1);
    return clamp(x);
}

/// Any length from nothing to the longest, each order of magnitude equally likely; often along an
/// axis.
Uv HeightTestModel::other_end(Random& random, Uv u1, int max_edge) const {
    const uint64_t longest = static_cast<uint64_t>(max_edge) << profile().uv.frac;
    const uint64_t extent = std::min(random.of_any_length(profile().uv.width), longest);
    int64_t dx = static_cast<int64_t>(extent);
    int64_t dy = static_cast<int64_t>(random.below(static_cast<uint32_t>(extent) + 1));
    const uint32_t kind = random.below(100);
    if (kind < 20) dy = 0;
    if (kind >= 95) dy = dx;
    if (random.percent(50)) std::swap(dx, dy);
    const auto toward_map = [](int32_t x, int64_t d) { return x > 0 ? x - d : x + d; };
    const bool inward = random.percent(80);
    return {clamp(inward ? toward_map(u1.x, dx) : u1.x + dx),
            clamp(inward ? toward_map(u1.y, dy) : u1.y - dy)};
}

Uv HeightTestModel::position(Random& random, const HeightTestRegisters& registers) const {
    return {coordinate(random, registers.width, registers.wrap),
            coordinate(random, registers.height, registers.wrap)};
}

Scenario HeightTestModel::random(Random& random, std::size_t count) const {
    Scenario s{"random", {}, pool()[random.below(static_cast<uint32_t>(pool().size()))], {}};
    HeightTestRegisters registers;
    registers.width = s.table->width;
    registers.height = s.table->height;
    registers.wrap = random.percent(50);
    registers.box = random.percent(50) ? BoxKind::Square : BoxKind::Literal;
    registers.mode = random.percent(50) ? HeightMode::Average : HeightMode::Sum;
    HeightTest unit(profile());
    unit.configure(registers, s.table->entries);

    s.inputs.reserve(count * inputs());
    HeightTestIn in;
    for (std::size_t i = 0; i < count; ++i) {
        in.u1 = position(random, registers);
        in.u2 = other_end(random, in.u1, unit.max_edge());
        in.u12 = {(in.u1.x + in.u2.x) >> 1, (in.u1.y + in.u2.y) >> 1};
        in.skip = random.percent(5) || !unit.accepts(in.u1, in.u2, in.u12);
        s.add(in);
    }

    // Most thresholds are such that the last edge just passes, or just fails, the comparison.
    const uint64_t most = max_threshold(registers.mode);
    const uint32_t kind = random.below(100);
    if (kind < 60) {
        const int64_t border =
            static_cast<int64_t>(border_threshold(unit, registers, s.table->entries, in, most));
        const int64_t near = border + random.between(-1, 1);
        registers.threshold =
            static_cast<uint64_t>(std::clamp<int64_t>(near, 0, static_cast<int64_t>(most)));
    } else if (kind < 90) {
        registers.threshold = random.next() & most & (~uint64_t{0} >> random.below(64));
    } else {
        registers.threshold = kind < 95 ? 0 : most;
    }
    const auto config = registers.pack();
    s.config.assign(config.begin(), config.end());
    return s;
}

Scenario HeightTestModel::exhaustive(uint64_t portion) const {
    struct Shape {
        int width, height;
    };
    constexpr std::array kShapes = {Shape{1, 1}, Shape{2, 2}, Shape{3, 3}, Shape{2, 3},
                                    Shape{3, 2}};
    const auto digit = [&portion](uint64_t base) {
        const uint64_t d = portion % base;
        portion /= base;
        return d;
    };
    HeightTestRegisters registers;
    registers.wrap = digit(2) != 0;
    registers.box = digit(2) != 0 ? BoxKind::Literal : BoxKind::Square;
    registers.mode = digit(2) != 0 ? HeightMode::Sum : HeightMode::Average;
    registers.threshold = digit(4);
    const Shape shape = kShapes[digit(kShapes.size())];
    registers.width = shape.width;
    registers.height = shape.height;
    const uint64_t map = digit(2);
    if (portion != 0) return {};

    Random random(7 + map);
    const auto config = registers.pack();
    Scenario s{"exhaustive", {config.begin(), config.end()}, nullptr, {}};
    s.table = prefix_sums(shape.width, shape.height, profile().sat_width,
                          [&](int, int) { return random.below(1U << profile().height.width); });
    HeightTest unit(profile());
    unit.configure(registers, s.table->entries);
    const int width = profile().uv.width;
    const uint64_t mask = (uint64_t{1} << width) - 1;
    const auto word = [&](uint64_t bits) {
        return static_cast<int32_t>(bits & mask) - (1 << (width - 1));
    };
    for (uint64_t i = 0; i < uint64_t{1} << 4 * width; ++i) {
        HeightTestIn in;
        in.u1 = {word(i), word(i >> width)};
        in.u2 = {word(i >> 2 * width), word(i >> 3 * width)};
        in.u12 = {(in.u1.x + in.u2.x) >> 1, (in.u1.y + in.u2.y) >> 1};
        in.skip = !unit.accepts(in.u1, in.u2, in.u12);
        s.add(in);
    }
    return s;
}

}  // namespace

std::unique_ptr<UnitModel> make_height_test_model(const Profile& profile) {
    return std::make_unique<HeightTestModel>(profile);
}

}  // namespace repousse::cosim
