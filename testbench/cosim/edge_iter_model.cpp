#include "datapath/units/edge_iter.h"

#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

/// All of it is 2^15 triangles for each of sixteen caps, so random and exhaustive differ in the
/// order alone.
class EdgeIterModel : public UnitModel {
public:
    explicit EdgeIterModel(const Profile& profile) : UnitModel(profile, kEdgeIterDesc) {}

    const UnitDesc& desc() const override { return kEdgeIterDesc; }
    std::vector<Scenario> hard_cases() const override;
    Scenario random(Random& random, std::size_t count) const override;
    Scenario exhaustive(uint64_t portion) const override;

    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override {
        unit_.configure(static_cast<int>(scenario.config.at(0)));
        outputs.clear();
        for (std::size_t i = 0; i < scenario.inputs.size(); i += inputs()) {
            for (const EdgeIterOut& edge : unit_(EdgeIterIn::unpack(&scenario.inputs[i]))) {
                for (const int64_t word : edge.pack()) outputs.push_back(word);
            }
        }
    }

    std::unique_ptr<UnitModel> with(const Profile& profile) const override {
        return make_edge_iter_model(profile);
    }

    /// No entry of a profile changes it.
    Profile tiny_profile() const override { return profile(); }

private:
    EdgeIter<Fixed> unit_;
};

EdgeIterIn triangle(uint64_t bits) {
    const auto generation = [bits](int i) { return static_cast<uint8_t>(bits >> 4 * i & 15); };
    return {{generation(0), generation(1), generation(2)}, static_cast<uint8_t>(bits >> 12 & 7)};
}

std::vector<Scenario> EdgeIterModel::hard_cases() const {
    std::vector<Scenario> cases;
    const auto begin = [&cases](const char* name, int64_t cap) {
        cases.push_back({name, {cap}, nullptr, {}});
    };
    const auto add = [&cases](uint8_t g1, uint8_t g2, uint8_t g3, uint8_t unsplit = 0) {
        cases.back().add(EdgeIterIn{{g1, g2, g3}, unsplit});
    };

    begin("cap_zero", 0);  // nothing is ever split
    add(0, 0, 0);
    add(15, 0, 15);

    begin("cap_max", EdgeIter<Fixed>::kMaxCap);
    add(0, 0, 0);
    add(14, 14, 14);
    add(15, 14, 14);
    add(15, 15, 15);

    begin("one_end_at_the_cap", 4);  // the higher end decides
    for (const uint8_t g : {uint8_t{3}, uint8_t{4}, uint8_t{5}}) {
        add(g, 0, 0);
        add(0, g, 0);
        add(0, 0, g);
    }

    begin("known_unsplit", 4);
    for (uint8_t unsplit = 0; unsplit < 8; ++unsplit) {
        add(0, 0, 0, unsplit);
        add(0, 4, 0, unsplit);
    }
    return cases;
}

Scenario EdgeIterModel::random(Random& random, std::size_t count) const {
    Scenario s{"random", {random.below(16)}, nullptr, {}};
    s.inputs.reserve(count * inputs());
    for (std::size_t i = 0; i < count; ++i) s.add(triangle(random.next()));
    return s;
}

Scenario EdgeIterModel::exhaustive(uint64_t portion) const {
    if (portion > EdgeIter<Fixed>::kMaxCap) return {};
    Scenario s{"exhaustive", {static_cast<int64_t>(portion)}, nullptr, {}};
    for (uint64_t i = 0; i < uint64_t{1} << 15; ++i) s.add(triangle(i));
    return s;
}

}  // namespace

std::unique_ptr<UnitModel> make_edge_iter_model(const Profile& profile) {
    return std::make_unique<EdgeIterModel>(profile);
}

}  // namespace repousse::cosim
