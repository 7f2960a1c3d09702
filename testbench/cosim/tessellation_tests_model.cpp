#include <algorithm>
#include <array>

#include "datapath/pipelines/tessellation_tests.h"
#include "testbench/cosim/table_pool.h"
#include "testbench/cosim/tessellation_tests_cases.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

/// The top's judge: the tests as the adaptive pipeline composes them.
class TessellationTestsModel : public UnitModel {
public:
    explicit TessellationTestsModel(const Profile& profile)
        : UnitModel(profile, kTessellationTestsDesc),
          texcoord_(make_texcoord_test_model(profile)),
          view_(make_view_test_model(profile)),
          normal_(make_normal_test_model(profile)),
          height_(make_height_test_model(profile)) {}

    const UnitDesc& desc() const override { return kTessellationTestsDesc; }
    bool reads_table() const override { return true; }
    std::vector<Scenario> hard_cases() const override {
        return tessellation_tests_cases(profile());
    }
    Scenario random(Random& random, std::size_t count) const override;
    Scenario exhaustive(uint64_t portion) const override;

    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override {
        TessellationTests<Fixed> unit(profile(), unpack_registers(scenario.config.data()),
                                      scenario.table->entries);
        answer_each(scenario, outputs,
                    [&](const Word* in) { return unit(TessellationTestsIn::unpack(in)).pack(); });
    }

    uint64_t icarus_weight() const override { return 4; }

    std::unique_ptr<UnitModel> with(const Profile& profile) const override {
        return make_tessellation_tests_model(profile);
    }

    /// As few values for each test as let it say yes and no: s1.1 coordinates on a map of 2 x 2
    /// texels of two bits, screens of s2.0, normals of three bits with different fractions.
    Profile tiny_profile() const override {
        Profile tiny = profile();
        tiny.uv.width = 3, tiny.uv.frac = 1;
        tiny.screen.width = 3, tiny.screen.frac = 0;
        tiny.displaced_normal.width = 3, tiny.displaced_normal.frac = 1;
        tiny.map_normal.width = 3, tiny.map_normal.frac = 0;
        tiny.normal.width = 3, tiny.normal.frac = 2;
        tiny.height.width = 2, tiny.height.frac = 0;
        tiny.sat_width = 8;
        return tiny;
    }

private:
    static void append(std::vector<int64_t>& to, const int64_t* words, std::size_t count) {
        to.insert(to.end(), words, words + count);
    }

    // Where transactions come from: each test's own random ones, most of them near its border.
    std::unique_ptr<UnitModel> texcoord_, view_, normal_, height_;
};

Scenario TessellationTestsModel::random(Random& random, std::size_t count) const {
    const Scenario texcoord = texcoord_->random(random, count);
    const Scenario view = view_->random(random, count);
    const Scenario normal = normal_->random(random, count);
    const Scenario height = height_->random(random, count);
    const bool use_height_test = random.percent(85);
    const bool near_texels = !use_height_test && random.percent(70);
    Scenario s{
        "random", {random.percent(25), random.percent(85), random.percent(85)}, height.table, {}};
    s.config.push_back(use_height_test);
    for (const Scenario* part : {&view, &normal, &height}) {
        append(s.config, part->config.data(), part->config.size());
    }

    // The Summed Height Test is not defined for every edge: those that its own model skips give
    // their place to the last one before them.
    constexpr std::array<int64_t, 6> kNowhere{};
    const int64_t* on_the_map = kNowhere.data();
    const std::size_t uv = texcoord_->inputs(), points = view_->inputs(), n = normal_->inputs();
    s.inputs.reserve(count * inputs());
    for (std::size_t i = 0; i < count; ++i) {
        if (height.inputs[i * uv] == 0) on_the_map = &height.inputs[i * uv + 1];
        s.inputs.push_back(random.percent(95));
        append(s.inputs, near_texels ? &texcoord.inputs[i * uv + 1] : on_the_map, uv - 1);
        append(s.inputs, &view.inputs[i * points + 1], points - 1);
        append(s.inputs, &normal.inputs[i * n + 1], n - 1);
    }
    return s;
}

/// All U1 and U2, three lengths on the screen and a near end, three bends of the normal, eligible
/// or not: 2^17 edges for each way to use the tests, both spaces of the normals, sums and averages,
/// clamped and periodic.
Scenario TessellationTestsModel::exhaustive(uint64_t portion) const {
    const auto digit = [&portion](uint64_t base) {
        const uint64_t d = portion % base;
        portion /= base;
        return d;
    };
    AdaptiveRegisters<Fixed> r;
    r.eager = digit(2) != 0;
    r.use_view_test = digit(2) != 0;
    r.use_normal_test = digit(2) != 0;
    r.use_height_test = digit(2) != 0;
    r.normal_space = digit(2) != 0 ? NormalSpace::Map : NormalSpace::World;
    r.height_test.wrap = digit(2) != 0;
    r.height_test.mode = digit(2) != 0 ? HeightMode::Sum : HeightMode::Average;
    if (portion != 0) return {};
    r.view_threshold = r.normal_threshold = 1;
    r.height_test.threshold = 1;
    r.height_test.width = r.height_test.height = 2;

    const auto config = pack_registers(r);
    Scenario s{"exhaustive", {config.begin(), config.end()}, nullptr, {}};
    s.table = prefix_sums(2, 2, profile().sat_width, [](int x, int y) { return x == y ? 3U : 0U; });
    HeightTest height(profile());
    height.configure(r.height_test, s.table->entries);
    constexpr int kEdgeBits = 17;
    for (uint64_t i = 0; i < uint64_t{1} << kEdgeBits; ++i) {
        const auto bits = [i](int at, int count) {
            return static_cast<int32_t>(i >> at & ((uint64_t{1} << count) - 1));
        };
        TessellationTestsIn in;
        in.u1 = {bits(0, 3) - 4, bits(3, 3) - 4};
        in.u2 = {bits(6, 3) - 4, bits(9, 3) - 4};
        in.u12 = {(in.u1.x + in.u2.x) >> 1, (in.u1.y + in.u2.y) >> 1};
        in.p1.near = bits(12, 2) == 3;
        in.p2.x = bits(12, 2) % 3;
        const int32_t bend = bits(14, 2) - 2;
        in.vertices[2].displaced_normal.x = bend;
        in.vertices[2].map_normal.y = bend;
        in.vertices[2].normal.z = bits(14, 2) == 3 ? 3 : 0;
        in.eligible = bits(16, 1) != 0;
        if (r.use_height_test && !height.accepts(in.u1, in.u2, in.u12)) in.u1 = in.u2 = in.u12 = {};
        s.add(in);
    }
    return s;
}

}  // namespace

std::unique_ptr<UnitModel> make_tessellation_tests_model(const Profile& profile) {
    return std::make_unique<TessellationTestsModel>(profile);
}

}  // namespace repousse::cosim
