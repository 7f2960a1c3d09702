#include <algorithm>
#include <array>

#include "datapath/numbers/policy.h"
#include "datapath/units/normalise.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

class NormaliseModel : public UnitModel {
public:
    explicit NormaliseModel(const Profile& profile)
        : UnitModel(profile, kNormaliseDesc), unit_(profile) {}

    const UnitDesc& desc() const override { return kNormaliseDesc; }
    std::vector<Scenario> hard_cases() const override;
    Scenario random(Random& random, std::size_t count) const override;
    Scenario exhaustive(uint64_t portion) const override;

    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override {
        answer_each(scenario, outputs, [this](const Word* in) {
            const auto word = [in](std::size_t k) { return static_cast<int32_t>(in[k]); };
            const Vec3<int32_t> unit = unit_({word(0), word(1), word(2)});
            return std::array<Word, 3>{unit.x, unit.y, unit.z};
        });
    }

    std::unique_ptr<UnitModel> with(const Profile& profile) const override {
        return make_normalise_model(profile);
    }

    /// Components of 8 bits: 2^24 vectors.
    Profile tiny_profile() const override {
        Profile tiny = profile();
        tiny.unnormalised.width = 8, tiny.unnormalised.frac = 6;
        tiny.normal.width = 8, tiny.normal.frac = 6;
        return tiny;
    }

private:
    static void add(Scenario& s, int64_t x, int64_t y, int64_t z) {
        for (const int64_t word : {x, y, z}) s.inputs.push_back(word);
    }

    /// All places and signs of three components.
    static void add_all(Scenario& s, int64_t a, int64_t b, int64_t c) {
        for (int signs = 0; signs < 8; ++signs) {
            const int64_t x = signs & 1 ? -a : a, y = signs & 2 ? -b : b, z = signs & 4 ? -c : c;
            add(s, x, y, z);
            add(s, y, z, x);
            add(s, z, x, y);
        }
    }

    Normalise<Fixed> unit_;
};

std::vector<Scenario> NormaliseModel::hard_cases() const {
    std::vector<Scenario> cases;
    const auto begin = [&cases](const char* name) { cases.push_back({name, {}, nullptr, {}}); };
    const int64_t most = profile().unnormalised.max_raw();
    const int64_t least = profile().unnormalised.min_raw();
    const int bits = profile().unnormalised.width - 1;
    const int64_t one = std::min(most, int64_t{1} << std::max(0, profile().unnormalised.frac));

    begin("zero");  // no direction: stays zero, also between others
    add(cases.back(), 0, 0, 0);
    add(cases.back(), 0, 0, one);
    add(cases.back(), 0, 0, 0);
    begin("one_lsb");  // and two and three: the unit's error does not depend on the length
    for (const int64_t a : {0, 1, 2, 3}) {
        for (const int64_t b : {0, 1, 2, 3}) add_all(cases.back(), a, b, 1);
    }
    begin("axes");  // exact, whatever the length
    for (const int64_t a : {int64_t{1}, int64_t{3}, one, most}) add_all(cases.back(), a, 0, 0);
    add(cases.back(), least, 0, 0);
    add(cases.back(), 0, least, 0);
    add(cases.back(), 0, 0, least);
    begin("powers_of_two");  // 4^n and its neighbours, whose root is exact or nearly so
    for (int k = 0; k < bits; ++k) {
        const int64_t a = int64_t{1} << k;
        add(cases.back(), a, 0, 0);
        add(cases.back(), a, 1, 0);
        add(cases.back(), -a, a, 0);
        add(cases.back(), a, -a, a);
    }
    begin("saturated_corners");  // the longest squared lengths
    for (const int64_t x : {least, most}) {
        for (const int64_t y : {least, most}) {
            for (const int64_t z : {least, int64_t{0}, most}) add(cases.back(), x, y, z);
        }
    }
    begin("antiparallel_sums");  // what is left of two opposite unit vectors
    for (const int64_t left : {1, 2, 4}) {
        add_all(cases.back(), left, 0, 0);
        add_all(cases.back(), left, left, 0);
        add_all(cases.back(), left, left, left);
    }
    begin("ties");  // halves of the last bit kept: (3, 4), (5, 12), (8, 15) times powers of two
    for (int k = 0; k + 4 < bits; ++k) {
        const int64_t s = int64_t{1} << k;
        add(cases.back(), 3 * s, 4 * s, 0);
        add(cases.back(), -5 * s, 0, 12 * s);
        add(cases.back(), 0, 8 * s, -15 * s);
        add(cases.back(), -1, 0, s);  // near half a unit beside an axis
    }
    begin("beside_an_axis");  // one component far below the others
    for (const int64_t small : {1, 2, 3, 5}) {
        add_all(cases.back(), small, most, 0);
        add_all(cases.back(), small, one, one);
    }
    return cases;
}

Scenario NormaliseModel::random(Random& random, std::size_t count) const {
    Scenario s{"random", {}, nullptr, {}};
    s.inputs.reserve(3 * count);
    const int bits = profile().unnormalised.width - 1;
    for (std::size_t i = 0; i < count; ++i) {
        // Of one length or of three, near zero or not.
        const bool alike = random.percent(60);
        const auto length = 1 + static_cast<int>(random.below(static_cast<uint32_t>(bits)));
        const int64_t limit = (int64_t{1} << length) - 1;
        for (int k = 0; k < 3; ++k) {
            int64_t word = alike ? random.between(-limit, limit)
                                 : static_cast<int64_t>(random.of_any_length(bits));
            if (!alike && random.percent(50)) word = -word;
            if (random.percent(3)) word = 0;
            s.inputs.push_back(word);
        }
    }
    return s;
}

Scenario NormaliseModel::exhaustive(uint64_t portion) const {
    if (portion >= 256 || profile().unnormalised.width != 8) return {};
    Scenario s{"exhaustive", {}, nullptr, {}};
    for (int64_t y = -128; y < 128; ++y) {
        for (int64_t z = -128; z < 128; ++z) add(s, static_cast<int64_t>(portion) - 128, y, z);
    }
    return s;
}

}  // namespace

std::unique_ptr<UnitModel> make_normalise_model(const Profile& profile) {
    return std::make_unique<NormaliseModel>(profile);
}

}  // namespace repousse::cosim
