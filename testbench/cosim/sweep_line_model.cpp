#include <algorithm>

#include "datapath/sweep_line_ports.h"
#include "datapath/units/triangle_setup.h"
#include "testbench/cosim/sweep_line_cases.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

/// The sweep line's judge. An item is a base triangle that went through the setup; random ones
/// come with random vertex data, so every bit of every adder matters.
class SweepLineModel : public UnitModel {
public:
    explicit SweepLineModel(const Profile& profile)
        : UnitModel(profile, kSweepLineDesc),
          setup_({static_cast<AdderKind>(profile.adder_kind), profile.guard_bits,
                  profile.components}) {}

    const UnitDesc& desc() const override { return kSweepLineDesc; }
    /// A base triangle is some 30 beats, of four vertices' words each.
    std::size_t batch() const override { return 128; }
    uint64_t weight() const override { return 10; }
    uint64_t icarus_weight() const override { return 500; }

    std::vector<Scenario> hard_cases() const override;
    Scenario random(Random& random, std::size_t count) const override;
    Scenario exhaustive(uint64_t portion) const override;
    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override;

    std::unique_ptr<UnitModel> with(const Profile& profile) const override {
        return make_sweep_line_model(profile);
    }

    /// One component of vertex data: topology does not depend on how many there are.
    Profile tiny_profile() const override {
        Profile tiny = profile();
        tiny.components = 1;
        return tiny;
    }

private:
    SweepLineIn item(const GridCorners& corners, Random& random) const;
    void add(Scenario& scenario, const SweepLineIn& in) const {
        const std::vector<Word> words = in.pack(profile());
        scenario.inputs.insert(scenario.inputs.end(), words.begin(), words.end());
    }

    TriangleSetup setup_;
};

SweepLineIn SweepLineModel::item(const GridCorners& grid, Random& random) const {
    std::array<SweepCorner, 3> corners;
    const uint32_t first = random.below(3);  // which end of an edge is the canonical one
    const int spare = 32 - sweep_data_width(profile());
    for (std::size_t i = 0; i < 3; ++i) {
        corners[i].id = (static_cast<uint32_t>(i) + first) % 3;
        corners[i].slot = grid[i];
        for (int32_t& x : corners[i].data) x = static_cast<int32_t>(random.next() >> 32) >> spare;
    }
    SweepLineIn in;
    TriangleSetup setup = setup_;
    setup(corners, in.triangle);
    return in;
}

std::vector<Scenario> SweepLineModel::hard_cases() const {
    std::vector<Scenario> cases;
    Random random(1);
    for (const SweepCase& c : sweep_hard_cases()) {
        cases.push_back({c.name, {0}, nullptr, {}});
        for (const GridCorners& corners : c.triangles) add(cases.back(), item(corners, random));
    }
    // Columns that may take no step, or one; then a triangle as ever.
    cases.push_back({"runaway", {0}, nullptr, {}});
    for (const uint32_t limit : {0U, 1U, 2U, 100U}) {
        SweepLineIn in = item({{{0, 0, 0}, {6, 1, 0}, {3, 5, 0}}}, random);
        in.triangle.step_limit = limit;
        add(cases.back(), in);
    }
    cases.push_back({"abort", {1}, nullptr, {}});
    for (const SweepCase& c : sweep_hard_cases()) {
        add(cases.back(), item(c.triangles.front(), random));
        if (cases.back().inputs.size() == 3 * inputs()) break;
    }
    return cases;
}

Scenario SweepLineModel::random(Random& random, std::size_t count) const {
    Scenario s{"random", {random.percent(1)}, nullptr, {}};
    s.inputs.reserve(count * inputs());
    for (std::size_t i = 0; i < count; ++i) {
        SweepLineIn in = item(any_sweep_triangle(random), random);
        if (random.below(256) == 0) in.triangle.step_limit = random.below(8);
        add(s, in);
    }
    return s;
}

/// All ordered triples of a 5^3 grid, a first corner in each portion.
Scenario SweepLineModel::exhaustive(uint64_t portion) const {
    if (portion >= 125) return {};
    Scenario s{"exhaustive", {0}, nullptr, {}};
    const auto corner = [](uint64_t n) {
        return std::array<int32_t, 3>{static_cast<int32_t>(n / 25), static_cast<int32_t>(n / 5 % 5),
                                      static_cast<int32_t>(n % 5)};
    };
    Random random(portion);
    for (uint64_t n = 0; n < 125 * 125; ++n) {
        add(s, item({corner(portion), corner(n / 125), corner(n % 125)}, random));
    }
    return s;
}

void SweepLineModel::evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) {
    outputs.clear();
    SweepLine unit({profile().column_depth, {}});
    for (std::size_t i = 0; i < scenario.inputs.size(); i += inputs()) {
        const SweepLineIn in = SweepLineIn::unpack(&scenario.inputs[i], profile());
        sweep_beats(unit, in, scenario.config.at(0) != 0, [&](const SweepLineOut& beat) {
            const std::vector<Word> words = beat.pack(profile());
            outputs.insert(outputs.end(), words.begin(), words.end());
        });
    }
}

}  // namespace

std::unique_ptr<UnitModel> make_sweep_line_model(const Profile& profile) {
    return std::make_unique<SweepLineModel>(profile);
}

}  // namespace repousse::cosim
