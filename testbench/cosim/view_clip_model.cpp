#include <algorithm>
#include <array>
#include <cmath>

#include "datapath/numbers/policy.h"
#include "datapath/units/view_clip.h"
#include "testbench/cosim/unit_model.h"
#include "testbench/host/clip_registers.h"

namespace repousse::cosim {
namespace {

using Eye = EyePoint<Fixed>;
using Registers = ClipRegisters<Fixed>;

std::vector<int64_t> words(const Registers& r) {
    return {r.near, r.far, r.cosine_x, r.sine_x, r.cosine_y, r.sine_y, r.margin};
}

Registers registers(const std::vector<int64_t>& w) {
    const auto v = [&w](std::size_t i) { return static_cast<int32_t>(w.at(i)); };
    return {v(0), v(1), v(2), v(3), v(4), v(5), v(6)};
}

class ViewClipModel : public UnitModel {
public:
    explicit ViewClipModel(const Profile& profile)
        : UnitModel(profile, kViewClipDesc), unit_(profile) {}

    const UnitDesc& desc() const override { return kViewClipDesc; }
    std::vector<Scenario> hard_cases() const override;
    Scenario random(Random& random, std::size_t count) const override;
    Scenario exhaustive(uint64_t portion) const override;

    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override {
        unit_.configure(registers(scenario.config));
        answer_each(scenario, outputs, [this](const Word* words) {
            const ViewClipIn in = ViewClipIn::unpack(words);
            const unsigned outside = unit_.outside(in.corners, in.max_displacement);
            return std::array<Word, 2>{outside != 0, outside};
        });
    }

    std::unique_ptr<UnitModel> with(const Profile& profile) const override {
        return make_view_clip_model(profile);
    }

    /// Four bits for everything: equal corners, and x = y, leave 2^20 transactions a setting.
    Profile tiny_profile() const override {
        Profile tiny = profile();
        tiny.clip.width = 4, tiny.clip.frac = 1;
        tiny.view_row.width = 4, tiny.view_row.frac = 2;
        tiny.displacement.width = 4, tiny.displacement.frac = 2;
        return tiny;
    }

private:
    int32_t most() const { return static_cast<int32_t>(profile().clip.max_raw()); }
    int32_t least() const { return static_cast<int32_t>(profile().clip.min_raw()); }
    int32_t reach() const { return static_cast<int32_t>(profile().displacement.max_raw()); }
    int32_t clamp(double x) const {
        return static_cast<int32_t>(std::clamp(std::floor(x), double(least()), double(most())));
    }

    Registers view(double fov_deg, double near, double far) const {
        host::CameraSettings camera;
        camera.fov_deg = fov_deg;
        camera.near = near;
        camera.far = far;
        return host::make_clip_registers<Fixed>(profile(), camera, {1280, 720});
    }

    Eye near_a_plane(Random& random, const Registers& r, double distance) const;

    ViewClip<Fixed> unit_;
};

/// A point that is `distance` (in LSB) beyond a plane of the view, give or take two LSB.
Eye ViewClipModel::near_a_plane(Random& random, const Registers& r, double distance) const {
    const uint32_t plane = random.below(6);
    const double w = static_cast<double>(random.of_any_length(profile().clip.width - 2));
    const double by = distance + static_cast<double>(random.between(-2, 2));
    const auto side = [&](int32_t sine, int32_t cosine, bool positive) {
        const double one = std::ldexp(1.0, profile().view_row.frac);
        const double x = cosine > 0 ? (w * sine + by * one) / cosine : 0.0;
        return clamp(positive ? x : -x);
    };
    const auto x = static_cast<int32_t>(random.between(least(), most()) >> random.below(16));
    const auto y = static_cast<int32_t>(random.between(least(), most()) >> random.below(16));
    switch (plane) {
        case 0:
        case 1:
            return {side(r.sine_x, r.cosine_x, plane == 1), y, clamp(w)};
        case 2:
        case 3:
            return {x, side(r.sine_y, r.cosine_y, plane == 3), clamp(w)};
        case 4:
            return {x, y, clamp(r.near - by)};
        default:
            return {x, y, clamp(r.far + by)};
    }
}

std::vector<Scenario> ViewClipModel::hard_cases() const {
    std::vector<Scenario> cases;
    const auto begin = [&cases](const char* name, const Registers& r) {
        cases.push_back({name, words(r), nullptr, {}});
    };
    const auto triangle = [&cases](Eye a, Eye b, Eye c, int32_t d) {
        cases.back().add(ViewClipIn{{a, b, c}, d});
        cases.back().add(ViewClipIn{{c, a, b}, d});
    };
    const auto all = [&cases](Eye e, int32_t d) { cases.back().add(ViewClipIn{{e, e, e}, d}); };
    const int32_t one = 1 << profile().clip.frac;
    const int32_t d_one = 1 << profile().displacement.frac;

    const Registers quarter = view(90, 1, 50);
    begin("each_plane", quarter);
    for (const int32_t x : {-11, -9, 0, 9, 11}) {
        for (const int32_t y : {-11, -9, 0, 9, 11}) {
            for (const int32_t w : {-10, 0, 1, 10, 60}) all({x * one, y * one, w * one}, 0);
        }
    }

    begin("one_lsb_around_the_reach", quarter);
    for (int32_t d : {0, 1, 15, 16, 17, d_one}) {
        for (int32_t by = -3; by <= 6; ++by) {
            const auto rounded_down = static_cast<int32_t>(int64_t{d} * one / d_one);
            const int32_t beyond = quarter.margin + by + rounded_down;
            all({0, 0, quarter.near - beyond}, d);
            all({0, 0, quarter.far + beyond}, d);
        }
    }

    begin("corners_beyond_different_planes", quarter);
    triangle({-20 * one, 0, 10 * one}, {20 * one, 0, 10 * one}, {0, 30 * one, 10 * one}, 0);
    triangle({-20 * one, 0, 10 * one}, {-20 * one, 0, 10 * one}, {20 * one, 0, 10 * one}, 0);

    begin("through_the_eye", quarter);
    triangle({0, 0, 0}, {5 * one, 0, 10 * one}, {-5 * one, 0, 10 * one}, 0);
    triangle({one, one, -5 * one}, {-one, one, 5 * one}, {0, -one, 5 * one}, d_one);

    begin("behind_the_eye", quarter);
    for (const int32_t d : {0, d_one, 8 * d_one}) {
        triangle({0, 0, -5 * one}, {one, 0, -6 * one}, {0, one, -7 * one}, d);
    }

    begin("displacement_larger_than_near", quarter);
    for (const int32_t d : {d_one - 1, d_one, d_one + 1, 5 * d_one, reach()}) {
        triangle({0, 0, one / 2}, {one, 0, one / 2}, {0, one, one / 2}, d);
        triangle({50 * one, 0, 10 * one}, {51 * one, 0, 10 * one}, {50 * one, one, 10 * one}, d);
    }

    begin("saturated_corners", quarter);
    for (const int32_t end : {least(), least() + 1, least() + 2, most() - 1, most()}) {
        all({end, 0, 10 * one}, 0);
        all({0, end, 10 * one}, 0);
        all({20 * one, 0, end}, 0);
        triangle({end, 0, one}, {30 * one, 0, one}, {30 * one, 0, one}, 0);
    }

    begin("widest_view", view(179.9, 1, 50));
    all({-100 * one, 0, one}, 0);
    all({0, 0, -one}, 0);

    begin("no_planes", {0, most(), 0, 0, 0, 0, 0});
    all({most() - 1, least() + 2, one}, 0);
    all({0, 0, -1}, 0);

    const auto row = static_cast<int32_t>(profile().view_row.max_raw());
    begin("largest_products", {least(), most(), row, -row - 1, -row - 1, row, most()});
    for (const int32_t x : {least() + 2, most() - 1}) {
        for (const int32_t y : {least() + 2, most() - 1}) {
            for (const int32_t w : {least() + 2, most() - 1}) {
                all({x, y, w}, 0);
                all({x, y, w}, reach());
            }
        }
    }
    return cases;
}

Scenario ViewClipModel::random(Random& random, std::size_t count) const {
    Registers r =
        view(5 + random.below(150), 1.0 / (1 + random.below(100)), 1.0 + random.below(60));
    if (random.percent(10)) {  // anything at all
        const auto any = [&random](const Format& format) {
            return static_cast<int32_t>(random.between(format.min_raw(), format.max_raw()));
        };
        const Format& clip = profile().clip;
        const Format& row = profile().view_row;
        r = {any(clip), any(clip), any(row), any(row), any(row), any(row), any(clip)};
    }
    Scenario s{"random", words(r), nullptr, {}};
    s.inputs.reserve(count * inputs());
    const int rise = profile().clip.frac - profile().displacement.frac;
    const auto anywhere = [&] {
        return static_cast<int32_t>(random.between(least(), most()) >> random.below(20));
    };
    for (std::size_t i = 0; i < count; ++i) {
        ViewClipIn in;
        in.max_displacement = static_cast<int32_t>(
            random.percent(20) ? 0 : random.of_any_length(profile().displacement.width - 1));
        const double distance = std::ceil(std::ldexp(in.max_displacement, rise)) + r.margin;
        for (Eye& e : in.corners) {
            e = random.percent(70) ? near_a_plane(random, r, distance)
                                   : Eye{anywhere(), anywhere(), anywhere()};
        }
        // Mostly all three beyond, or nearly beyond, the same plane.
        if (random.percent(60)) in.corners[1] = in.corners[2] = in.corners[0];
        s.add(in);
    }
    return s;
}

Scenario ViewClipModel::exhaustive(uint64_t portion) const {
    if (portion >= 16) return {};
    const auto word = [](uint64_t bits) {
        return static_cast<int32_t>(static_cast<uint32_t>(bits & 15) << 28) >> 28;
    };
    // Cosine and sine from a table of sixteen pairs, both ways round; near, far and margin follow.
    const Registers r{word(portion / 4),     word(7 - portion / 4), word(portion),
                      word(portion * 5 + 1), word(portion * 3 + 2), word(portion ^ 5),
                      word(portion / 3)};
    Scenario s{"exhaustive", words(r), nullptr, {}};
    for (uint64_t i = 0; i < uint64_t{1} << 20; ++i) {
        const Eye a{word(i), word(i >> 4), word(i >> 8)};
        s.add(ViewClipIn{{a, a, {a.x, a.y, word(i >> 12)}}, word(i >> 16)});
    }
    return s;
}

}  // namespace

std::unique_ptr<UnitModel> make_view_clip_model(const Profile& profile) {
    return std::make_unique<ViewClipModel>(profile);
}

}  // namespace repousse::cosim
