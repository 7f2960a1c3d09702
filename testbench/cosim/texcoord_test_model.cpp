#include "datapath/units/texcoord_test.h"

#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

class TexcoordTestModel : public UnitModel {
public:
    explicit TexcoordTestModel(const Profile& profile)
        : UnitModel(profile, kTexcoordTestDesc), unit_(profile) {}

    const UnitDesc& desc() const override { return kTexcoordTestDesc; }
    std::vector<Scenario> hard_cases() const override;
    Scenario random(Random& random, std::size_t count) const override;
    Scenario exhaustive(uint64_t portion) const override;

    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override {
        answer_each(scenario, outputs,
                    [this](const Word* in) { return unit_(TexcoordTestIn::unpack(in)).pack(); });
    }

    std::unique_ptr<UnitModel> with(const Profile& profile) const override {
        return make_texcoord_test_model(profile);
    }

    /// s2.1: 2^4 values for each of six coordinates.
    Profile tiny_profile() const override {
        Profile tiny = profile();
        tiny.uv.width = 4;
        tiny.uv.frac = 1;
        return tiny;
    }

private:
    static Uv middle(Uv a, Uv b) { return {(a.x + b.x) >> 1, (a.y + b.y) >> 1}; }
    int32_t one() const { return int32_t{1} << profile().uv.frac; }
    int32_t most() const { return static_cast<int32_t>(profile().uv.max_raw()); }
    int32_t least() const { return static_cast<int32_t>(profile().uv.min_raw()); }
    int32_t clamp(int64_t x) const {
        return static_cast<int32_t>(x < least() ? least() : x > most() ? most() : x);
    }

    TexcoordTest unit_;
};

std::vector<Scenario> TexcoordTestModel::hard_cases() const {
    const int32_t t = one();  // a texel
    std::vector<Scenario> cases;
    const auto begin = [&cases](const char* name) { cases.push_back({name, {}, nullptr, {}}); };
    const auto edge = [&cases](Uv u1, Uv u2, Uv u12, bool skip = false) {
        cases.back().add(TexcoordTestIn{skip, u1, u2, u12});
        cases.back().add(TexcoordTestIn{skip, u2, u1, u12});  // from the other side
    };
    const auto split = [&edge](Uv u1, Uv u2) { edge(u1, u2, middle(u1, u2)); };

    begin("degenerate");
    for (const int32_t x : {0, 1, t - 1, t, -1, -t, least(), most()}) split({x, x}, {x, x});

    begin("axis_aligned");
    for (int32_t d = 0; d <= 4 * t; d += t / 2 + (t == 1)) {
        split({0, 0}, {d, 0});
        split({0, 0}, {0, d});
        split({-d, t}, {0, t});
    }

    begin("texel_borders");  // one LSB on either side of a border
    for (const int32_t x : {-t, 0, t, 2 * t}) {
        for (const int32_t below : {-1, 0, 1}) {
            for (const int32_t above : {-1, 0, 1}) {
                split({x + below, 0}, {x + 2 * t + above, 0});
                split({0, x + below}, {0, x + 2 * t + above});
            }
        }
    }

    begin("negative_and_odd_sums");  // the floor of a negative odd sum goes down
    for (int32_t x = -2 * t - 3; x <= -2 * t + 3; ++x) split({x, -x}, {x + 2 * t + 1, -x - 2 * t});

    begin("one_component_differs");  // both components must match the same end
    edge({0, 0}, {4 * t, 4 * t}, {0, 4 * t});
    edge({0, 0}, {4 * t, 4 * t}, {4 * t, 0});
    edge({0, 0}, {4 * t, 4 * t}, {0, 0});
    edge({0, 0}, {4 * t, 0}, {2 * t, t});

    begin("seam");  // not wrapped first: texel W is not texel 0
    for (const int32_t w : {4 * t, 64 * t}) split({0, 0}, {clamp(w), 0});

    begin("range_ends");
    split({least(), least()}, {most(), most()});
    split({least(), most()}, {most(), least()});
    edge({most(), most()}, {least(), least()}, {most(), most()});

    begin("skipped");
    edge({0, 0}, {4 * t, 0}, {2 * t, 0}, true);
    edge({0, 0}, {0, 0}, {0, 0}, true);
    return cases;
}

Scenario TexcoordTestModel::random(Random& random, std::size_t count) const {
    Scenario s{"random", {}, nullptr, {}};
    s.inputs.reserve(count * inputs());
    const int64_t t = one();
    const auto anywhere = [&] {
        return static_cast<int32_t>(random.between(profile().uv.min_raw(), profile().uv.max_raw()));
    };
    // A few texels away, or near a texel's border.
    const auto nearby = [&](int32_t x) {
        const int64_t moved = x + random.between(-3 * t, 3 * t);
        const bool to_border = random.percent(50);
        return clamp(to_border ? (moved & -t) + random.between(-1, 1) : moved);
    };
    for (std::size_t i = 0; i < count; ++i) {
        TexcoordTestIn in;
        in.skip = random.percent(5);
        in.u1 = {anywhere(), anywhere()};
        in.u2 =
            random.percent(80) ? Uv{nearby(in.u1.x), nearby(in.u1.y)} : Uv{anywhere(), anywhere()};
        in.u12 = random.percent(70) ? middle(in.u1, in.u2) : Uv{nearby(in.u2.x), nearby(in.u2.y)};
        s.add(in);
    }
    return s;
}

Scenario TexcoordTestModel::exhaustive(uint64_t portion) const {
    const int width = profile().uv.width;
    const uint64_t values = uint64_t{1} << width;
    const auto word = [&](uint64_t bits) {
        const int spare = 32 - width;
        return static_cast<int32_t>(static_cast<uint32_t>(bits & (values - 1)) << spare) >> spare;
    };
    if (portion >= values * values) return {};
    Scenario s{"exhaustive", {}, nullptr, {}};
    const Uv u1{word(portion), word(portion >> width)};
    for (uint64_t i = 0; i < uint64_t{1} << 4 * width; ++i) {
        s.add(TexcoordTestIn{
            false, u1, {word(i), word(i >> width)}, {word(i >> 2 * width), word(i >> 3 * width)}});
    }
    return s;
}

}  // namespace

std::unique_ptr<UnitModel> make_texcoord_test_model(const Profile& profile) {
    return std::make_unique<TexcoordTestModel>(profile);
}

}  // namespace repousse::cosim
