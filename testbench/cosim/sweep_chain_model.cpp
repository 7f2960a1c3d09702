#include <algorithm>

#include "datapath/numbers/policy.h"
#include "datapath/pipelines/sweep_chain_desc.h"
#include "datapath/sweep_line_ports.h"
#include "datapath/units/perspective.h"
#include "datapath/units/strip.h"
#include "datapath/units/triangle_setup.h"
#include "testbench/cosim/sweep_line_cases.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

/// The chain's judge: the datapaths of its units, one after the other.
class SweepChainModel : public UnitModel {
public:
    explicit SweepChainModel(const Profile& profile)
        : UnitModel(profile, kSweepChainDesc),
          setup_(
              {static_cast<AdderKind>(profile.adder_kind), profile.guard_bits, profile.components}),
          perspective_(profile),
          strip_(static_cast<std::size_t>(profile.column_depth)) {}

    const UnitDesc& desc() const override { return kSweepChainDesc; }
    std::vector<Scenario> hard_cases() const override;
    Scenario random(Random& random, std::size_t count) const override;

    /// What is exhaustive about it, topology, is so in the sweep line alone.
    Scenario exhaustive(uint64_t) const override { return {}; }
    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override;

    std::size_t batch() const override { return 128; }
    uint64_t weight() const override { return 200; }
    uint64_t icarus_weight() const override { return 2000; }

    std::unique_ptr<UnitModel> with(const Profile& profile) const override {
        return make_sweep_chain_model(profile);
    }

    /// A column FIFO that is full in nearly every column, and no tangents.
    Profile tiny_profile() const override {
        Profile tiny = profile();
        tiny.column_depth = 3;
        tiny.components = kPlainComponents;
        return tiny;
    }

private:
    SweepLineIn item(const GridCorners& corners, Random& random) const;
    void add(Scenario& scenario, const SweepLineIn& in) const {
        const std::vector<Word> words = in.pack(profile());
        scenario.inputs.insert(scenario.inputs.end(), words.begin(), words.end());
    }
    void send(const SweepLineOut& beat, std::vector<int64_t>& outputs);

    TriangleSetup setup_;
    Perspective<Fixed> perspective_;
    Strip<uint32_t> strip_;                         // vertices by their numbers here:
    std::vector<CorrectedVertex<Fixed>> vertices_;  // those of the base triangle
};

/// Corners at distances that differ by up to 64, with attributes that mostly fit behind 1/c.
SweepLineIn SweepChainModel::item(const GridCorners& grid, Random& random) const {
    std::array<SweepCorner, 3> corners;
    const uint32_t first = random.below(3);  // which end of an edge is the canonical one
    const int spare = 32 - profile().sweep_data.width;
    const int c_frac = profile().inverse_w.frac;
    const bool is_wild = random.percent(5);
    for (std::size_t i = 0; i < 3; ++i) {
        corners[i].id = (static_cast<uint32_t>(i) + first) % 3;
        corners[i].slot = grid[i];
        const int64_t c = random.between((int64_t{1} << c_frac) >> 6, int64_t{1} << c_frac);
        for (int32_t& x : corners[i].data) {
            const int64_t v = static_cast<int32_t>(random.next() >> 32) >> spare;
            x = static_cast<int32_t>(is_wild ? v : v * c >> c_frac);
        }
        corners[i].data[kInverseWComponent] = static_cast<int32_t>(c);
    }
    SweepLineIn in;
    TriangleSetup setup = setup_;
    setup(corners, in.triangle);
    return in;
}

std::vector<Scenario> SweepChainModel::hard_cases() const {
    // The first two triangles of each of the sweep line's cases: a line here is long.
    std::vector<Scenario> cases;
    Random random(2);
    for (const SweepCase& c : sweep_hard_cases()) {
        cases.push_back({c.name, {0, 1}, nullptr, {}});
        for (std::size_t i = 0; i < std::min<std::size_t>(c.triangles.size(), 2); ++i) {
            add(cases.back(), item(c.triangles[i], random));
        }
    }
    // Given up in the middle, with vertices in both FIFOs; then a triangle as ever.
    cases.push_back({"runaway", {0, 1}, nullptr, {}});
    for (const uint32_t limit : {3U, 100U}) {
        SweepLineIn in = item({{{0, 0, 0}, {6, 1, 0}, {3, 5, 0}}}, random);
        in.triangle.step_limit = limit;
        add(cases.back(), in);
    }
    cases.push_back({"abort", {1, 1}, nullptr, {}});
    for (int i = 0; i < 2; ++i) {
        add(cases.back(), item({{{0, 0, 0}, {6, 1, 0}, {3, 5, 0}}}, random));
    }
    cases.push_back({"no_tangents", {0, 0}, nullptr, {}});
    add(cases.back(), item({{{0, 0, 0}, {4, 1, 0}, {2, 3, 0}}}, random));
    return cases;
}

Scenario SweepChainModel::random(Random& random, std::size_t count) const {
    Scenario s{"random", {random.percent(1), random.percent(75)}, nullptr, {}};
    s.inputs.reserve(count * inputs());
    for (std::size_t i = 0; i < count; ++i) {
        SweepLineIn in = item(any_sweep_triangle(random), random);
        if (random.below(64) == 0) in.triangle.step_limit = random.below(8);
        add(s, in);
    }
    return s;
}

void SweepChainModel::send(const SweepLineOut& beat, std::vector<int64_t>& outputs) {
    if (beat.step.strip.count == 0) strip_.flush();
    std::array<uint32_t, 4> fresh{};
    for (std::size_t i = 0; i < beat.step.vertex_count; ++i) {
        fresh[i] = static_cast<uint32_t>(vertices_.size());
        vertices_.push_back(perspective_.correct(beat.step.vertices[i].data));
    }
    const uint64_t bad_before = strip_.counters().bad_refs;
    StripTriangles<uint32_t> made;
    strip_(beat.step.strip, {fresh.data(), beat.step.vertex_count}, made);
    for (std::size_t t = kStripTriangles; t-- > 0;) {
        for (std::size_t k = 0; k < 3; ++k) {
            std::array<Word, sweep_chain_ports::kFields> words{};
            if (t < made.count) words = vertices_[made.triangles[t][k]].pack();
            outputs.insert(outputs.end(), words.begin(), words.end());
        }
    }
    for (const Word word : {Word{made.count}, Word{strip_.counters().bad_refs != bad_before},
                            Word{beat.runaway}, Word{beat.last}}) {
        outputs.push_back(word);
    }
}

void SweepChainModel::evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) {
    outputs.clear();
    perspective_.configure(scenario.config.at(1) != 0);
    SweepLine unit({profile().column_depth, {}});
    for (std::size_t i = 0; i < scenario.inputs.size(); i += inputs()) {
        const SweepLineIn in = SweepLineIn::unpack(&scenario.inputs[i], profile());
        vertices_.clear();
        sweep_beats(unit, in, scenario.config.at(0) != 0,
                    [&](const SweepLineOut& beat) { send(beat, outputs); });
    }
}

}  // namespace

std::unique_ptr<UnitModel> make_sweep_chain_model(const Profile& profile) {
    return std::make_unique<SweepChainModel>(profile);
}

}  // namespace repousse::cosim
