#include <algorithm>

#include "datapath/numbers/policy.h"
#include "datapath/units/perspective.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

using Data = Perspective<Fixed>::Data;

class PerspectiveModel : public UnitModel {
public:
    explicit PerspectiveModel(const Profile& profile)
        : UnitModel(profile, kPerspectiveDesc), unit_(profile) {}

    const UnitDesc& desc() const override { return kPerspectiveDesc; }
    std::vector<Scenario> hard_cases() const override;
    Scenario random(Random& random, std::size_t count) const override;
    Scenario exhaustive(uint64_t portion) const override;

    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override {
        unit_.configure(scenario.config.at(0) != 0);
        answer_each(scenario, outputs, [this](const Word* in) {
            Data data{};
            std::transform(in, in + data.size(), data.begin(),
                           [](Word word) { return static_cast<int32_t>(word); });
            return unit_.correct(data).pack();
        });
    }

    std::unique_ptr<UnitModel> with(const Profile& profile) const override {
        return make_perspective_model(profile);
    }

    /// s1.7 components and a c of s1.14: every pair of them, but for most negative c.
    Profile tiny_profile() const override {
        Profile tiny = profile();
        tiny.sweep_data.width = 9, tiny.sweep_data.frac = 7;
        tiny.inverse_w.width = 16, tiny.inverse_w.frac = 14;
        tiny.position.width = 14, tiny.position.frac = 8;
        tiny.unnormalised.width = 10, tiny.unnormalised.frac = 7;
        tiny.uv.width = 12, tiny.uv.frac = 4;
        return tiny;
    }

private:
    int32_t most() const { return static_cast<int32_t>(profile().sweep_data.max_raw()); }
    int32_t least() const { return static_cast<int32_t>(profile().sweep_data.min_raw()); }

    /// A vertex whose components are all `value` but c.
    static void add(Scenario& s, int32_t value, int32_t c) {
        for (int k = 0; k < kSweepComponents; ++k) {
            s.inputs.push_back(k == kInverseWComponent ? c : value);
        }
    }

    Perspective<Fixed> unit_;
};

std::vector<Scenario> PerspectiveModel::hard_cases() const {
    std::vector<Scenario> cases;
    const auto begin = [&cases](const char* name, bool tangents = true) {
        cases.push_back({name, {tangents}, nullptr, {}});
    };
    const auto vertex = [&cases](int32_t value, int32_t c) { add(cases.back(), value, c); };
    const auto most_c = static_cast<int32_t>(profile().inverse_w.max_raw());
    const auto least_c = static_cast<int32_t>(profile().inverse_w.min_raw());
    const int32_t one_c = 1 << profile().inverse_w.frac;
    const int32_t one = 1 << profile().sweep_data.frac;

    begin("reference_distance");  // c = 1: data pass unchanged
    for (const int32_t v : {0, 1, -1, one, -one, one / 2, one - 1, most(), least()}) {
        vertex(v, one_c);
    }
    begin("c_not_positive");
    for (const int32_t c : {0, -1, least_c}) {
        for (const int32_t v : {0, 1, -1, most(), least()}) vertex(v, c);
    }
    begin("c_least");
    for (const int32_t c : {1, 2, 3}) {
        for (const int32_t v : {0, 1, -1, 2, -2, 3, -3, most(), least()}) vertex(v, c);
    }
    begin("c_largest");
    for (const int32_t v : {1, -1, one, most(), least()}) {
        vertex(v, most_c);
        vertex(v, one_c - 1);
        vertex(v, one_c + 1);
    }
    begin("powers_of_two");
    for (int k = 0; k <= profile().inverse_w.frac; ++k) {
        vertex(3, 1 << k);
        vertex(-one, 1 << k);
        vertex(one, (1 << k) + 1);
    }
    begin("ties");  // halves of the last bit kept, of either sign
    for (int32_t v = -9; v <= 9; ++v) {
        for (const int shift : {0, 1, 2, 3, 9}) vertex(v * (1 << shift), one_c);
    }
    begin("handedness");
    vertex(-1, one_c / 2);
    vertex(0, one_c / 2);
    vertex(least(), 0);
    begin("without_tangents", false);
    vertex(-one, one_c / 3);
    vertex(most(), 1);
    return cases;
}

Scenario PerspectiveModel::random(Random& random, std::size_t count) const {
    Scenario s{"random", {random.percent(80)}, nullptr, {}};
    s.inputs.reserve(count * inputs());
    for (std::size_t i = 0; i < count; ++i) {
        int64_t c = static_cast<int64_t>(random.of_any_length(profile().inverse_w.width - 1));
        if (random.percent(2)) c = -c;
        const bool in_range = random.percent(80);  // quotients of at most 16
        for (int k = 0; k < kSweepComponents; ++k) {
            const int bits = profile().sweep_data.width - 1;
            int64_t v = static_cast<int64_t>(random.of_any_length(bits));
            if (in_range) {
                const int64_t limit = std::min<int64_t>(
                    most(), (c < 0 ? -c : c) * (int64_t{1} << (profile().sweep_data.frac + 4)) >>
                                profile().inverse_w.frac);
                v = random.between(0, limit);
            }
            if (random.percent(50)) v = -v;
            s.inputs.push_back(k == kInverseWComponent ? c : v);
        }
    }
    return s;
}

Scenario PerspectiveModel::exhaustive(uint64_t portion) const {
    // 2^9 values of a component, different ones in each component of a vertex, against every
    // positive c and some that are not.
    if (portion >= 1U << 9) return {};
    Scenario s{"exhaustive", {1}, nullptr, {}};
    for (int32_t c = -256; c < 1 << 15; ++c) {
        for (int k = 0; k < kSweepComponents; ++k) {
            const int32_t v = static_cast<int32_t>((portion + 39U * unsigned(k)) & 511) - 256;
            s.inputs.push_back(k == kInverseWComponent ? c : v);
        }
    }
    return s;
}

}  // namespace

std::unique_ptr<UnitModel> make_perspective_model(const Profile& profile) {
    return std::make_unique<PerspectiveModel>(profile);
}

}  // namespace repousse::cosim
