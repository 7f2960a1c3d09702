#include <algorithm>

#include "datapath/numbers/policy.h"
#include "datapath/units/view_test.h"
#include "testbench/cosim/raw_words.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

class ViewTestModel : public UnitModel {
public:
    explicit ViewTestModel(const Profile& profile)
        : UnitModel(profile, kViewTestDesc), unit_(profile) {}

    const UnitDesc& desc() const override { return kViewTestDesc; }
    std::vector<Scenario> hard_cases() const override;
    Scenario random(Random& random, std::size_t count) const override;
    Scenario exhaustive(uint64_t portion) const override;

    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override {
        unit_.configure(scenario.config.at(0));
        answer_each(scenario, outputs,
                    [this](const Word* in) { return unit_(ViewTestIn::unpack(in)).pack(); });
    }

    std::unique_ptr<UnitModel> with(const Profile& profile) const override {
        return make_view_test_model(profile);
    }

    /// s3.0: 2^4 values for each of four coordinates, 2^5 thresholds.
    Profile tiny_profile() const override {
        Profile tiny = profile();
        tiny.screen.width = 4;
        tiny.screen.frac = 0;
        return tiny;
    }

private:
    using Point = ScreenPoint<int32_t>;

    int32_t most() const { return static_cast<int32_t>(profile().screen.max_raw()); }
    int32_t least() const { return static_cast<int32_t>(profile().screen.min_raw()); }
    int64_t max_threshold() const { return ViewTest<Fixed>::max_threshold(profile()); }
    int32_t clamp(int64_t x) const { return limited(profile().screen, x); }

    ViewTest<Fixed> unit_;
};

std::vector<Scenario> ViewTestModel::hard_cases() const {
    std::vector<Scenario> cases;
    const auto begin = [&cases](const char* name, int64_t threshold) {
        cases.push_back({name, {threshold}, nullptr, {}});
    };
    const auto edge = [&cases](Point p1, Point p2, bool skip = false) {
        cases.back().add(ViewTestIn{skip, p1, p2});
        cases.back().add(ViewTestIn{skip, p2, p1});  // from the other side
    };
    const Point low{least(), least(), false};
    const Point high{most(), most(), false};
    const int64_t longest = 2 * (int64_t(most()) - least());

    begin("threshold_zero", 0);
    edge({0, 0, false}, {0, 0, false});
    edge({0, 0, false}, {1, 0, false});
    edge({0, 0, false}, {0, -1, false});
    edge(low, high);

    const int64_t middle = std::min<int64_t>(most(), 100);
    begin("threshold_equal", middle);  // strictly greater
    for (int64_t d = middle - 2; d <= middle + 2; ++d) {
        for (int64_t x = 0; x <= d; x += d / 4 + 1) {
            edge({0, 0, false}, {clamp(x), clamp(d - x), false});
            edge({0, 0, false}, {clamp(-x), clamp(d - x), false});
        }
    }

    begin("saturated", longest - 1);  // both coordinates at the ends of the format
    edge(low, high);
    edge({least(), most(), false}, {most(), least(), false});
    edge({least() + 1, least(), false}, high);
    edge({least() + 1, least() + 1, false}, high);

    begin("longest_is_not_longer", longest);
    edge(low, high);
    edge({least(), most(), false}, {most(), least(), false});

    begin("threshold_max", max_threshold());
    edge(low, high);
    edge({0, 0, true}, {0, 0, false});

    begin("near_plane", middle);  // a w <= near bit per end
    for (const bool near1 : {false, true}) {
        for (const bool near2 : {false, true}) {
            edge({0, 0, near1}, {0, 0, near2});
            edge({least(), 0, near1}, {most(), 0, near2});
            edge({0, 0, near1}, {0, 0, near2}, true);
        }
    }

    begin("negative", middle);
    edge({-1, -1, false}, {clamp(-middle), 0, false});
    edge({clamp(-middle), clamp(-middle), false}, {clamp(-middle - 1), clamp(-2 * middle), false});

    begin("skipped", 0);
    edge(low, high, true);
    return cases;
}

Scenario ViewTestModel::random(Random& random, std::size_t count) const {
    const int64_t threshold =
        static_cast<int64_t>(random.percent(90)   ? random.of_any_length(profile().screen.width + 1)
                             : random.percent(50) ? 0
                                                  : static_cast<uint64_t>(max_threshold()));
    Scenario s{"random", {threshold}, nullptr, {}};
    s.inputs.reserve(count * inputs());
    const auto anywhere = [&] {
        return random.percent(10) ? (random.percent(50) ? least() : most())
                                  : static_cast<int32_t>(random.between(least(), most()));
    };
    for (std::size_t i = 0; i < count; ++i) {
        ViewTestIn in;
        in.skip = random.percent(5);
        in.p1 = {anywhere(), anywhere(), random.percent(4)};
        in.p2 = {anywhere(), anywhere(), random.percent(4)};
        if (random.percent(75)) {
            // |dx| + |dy| = threshold - 1 .. threshold + 1, as far as the format allows.
            const int64_t d = std::max<int64_t>(0, threshold + random.between(-1, 1));
            const int64_t dx = random.between(0, std::min<int64_t>(d, most()));
            const int64_t dy = d - dx;
            in.p2.x = clamp(in.p1.x + (in.p1.x > 0 ? -dx : dx));
            in.p2.y = clamp(in.p1.y + (in.p1.y > 0 ? -dy : dy));
        }
        s.add(in);
    }
    return s;
}

Scenario ViewTestModel::exhaustive(uint64_t portion) const {
    const int width = profile().screen.width;
    const uint64_t mask = (uint64_t{1} << width) - 1;
    const auto word = [&](uint64_t bits) {
        const int spare = 32 - width;
        return static_cast<int32_t>(static_cast<uint32_t>(bits & mask) << spare) >> spare;
    };
    if (portion > static_cast<uint64_t>(max_threshold())) return {};
    Scenario s{"exhaustive", {static_cast<int64_t>(portion)}, nullptr, {}};
    for (uint64_t i = 0; i < uint64_t{1} << (4 * width + 3); ++i) {
        const uint64_t points = i >> 3;
        s.add(ViewTestIn{(i & 4) != 0,
                         {word(points), word(points >> width), (i & 1) != 0},
                         {word(points >> 2 * width), word(points >> 3 * width), (i & 2) != 0}});
    }
    return s;
}

}  // namespace

std::unique_ptr<UnitModel> make_view_test_model(const Profile& profile) {
    return std::make_unique<ViewTestModel>(profile);
}

}  // namespace repousse::cosim
