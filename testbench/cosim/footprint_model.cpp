#include <algorithm>

#include "datapath/numbers/policy.h"
#include "datapath/units/footprint.h"
#include "testbench/cosim/raw_words.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

using In = FootprintIn<Fixed>;
using Registers = FootprintRegisters<Fixed>;

Registers unpack_registers(const std::vector<int64_t>& w) {
    const auto word = [&w](std::size_t i) { return static_cast<int32_t>(w.at(i)); };
    return {word(0), word(1), word(2), word(3), {word(4), word(5), word(6)}};
}

class FootprintModel : public UnitModel {
public:
    explicit FootprintModel(const Profile& profile)
        : UnitModel(profile, kFootprintDesc), unit_(profile) {}

    const UnitDesc& desc() const override { return kFootprintDesc; }
    std::vector<Scenario> hard_cases() const override;
    Scenario random(Random& random, std::size_t count) const override;
    Scenario exhaustive(uint64_t portion) const override;

    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override {
        unit_.configure(unpack_registers(scenario.config));
        answer_each(scenario, outputs,
                    [this](const Word* words) { return pack(unit_(In::unpack(words))); });
    }

    std::unique_ptr<UnitModel> with(const Profile& profile) const override {
        return make_footprint_model(profile);
    }

    /// s2.2 coordinates, steps of s3.2, c and its steps of s1.4.
    Profile tiny_profile() const override {
        Profile tiny = profile();
        tiny.uv.width = 5, tiny.uv.frac = 2;
        tiny.sweep_data.width = 6, tiny.sweep_data.frac = 2;
        tiny.inverse_w.width = 6, tiny.inverse_w.frac = 4;
        tiny.position.width = 4, tiny.position.frac = 1;
        tiny.normal.width = 3, tiny.normal.frac = 1;
        return tiny;
    }

private:
    static Scenario begin(const char* name, const Registers& registers) {
        const auto config = registers.pack();
        return {name, {config.begin(), config.end()}, nullptr, {}};
    }
    int32_t one() const { return 1 << profile().uv.frac; }
    /// Largest map that the format of U holds.
    int most_texels() const {
        return static_cast<int>(
            std::min<int64_t>(profile().uv.max_raw() >> profile().uv.frac, 16384));
    }

    Footprint<Fixed> unit_;
};

std::vector<Scenario> FootprintModel::hard_cases() const {
    std::vector<Scenario> cases;
    const auto data = [this](double texels) {
        return limited(profile().sweep_data,
                       static_cast<int64_t>(texels * (1 << profile().sweep_data.frac)));
    };
    const int32_t one_c = 1 << profile().inverse_w.frac;
    const auto most = static_cast<int32_t>(profile().sweep_data.max_raw());
    const auto most_c = static_cast<int32_t>(profile().inverse_w.max_raw());
    const auto add = [&cases](NameKind kind, Uv u, int32_t c, const TexelStep<int32_t>& a,
                              const TexelStep<int32_t>& b) {
        In in;
        in.kind = kind;
        in.u = u, in.c = c;
        in.steps = {a, b};
        cases.back().add(in);
    };
    const Uv middle{20 * one(), 30 * one()};

    cases.push_back(begin("corner", {64, 64, 6, 0, {}}));  // whatever its steps
    add(NameKind::Corner, middle, one_c, {data(40), data(-3), 1}, {data(5), data(70), -9});
    cases.push_back(begin("edge", {64, 64, 6, 0, {}}));  // a square, whatever the second step
    add(NameKind::Edge, middle, one_c, {data(4), data(-7), 0}, {data(50), data(70), one_c});
    add(NameKind::Edge, middle, one_c, {data(-7), data(4), 0}, {0, 0, 0});
    cases.push_back(begin("levels", {64, 64, 6, 0, {}}));  // steps at the border of each
    for (int level = 0; level < 8; ++level) {
        for (const int32_t beside : {-2, -1, 0, 1, 2}) {
            const int32_t step =
                limited(profile().sweep_data, (int64_t{data(1)} << level) + beside);
            add(NameKind::Interior, middle, one_c, {step, 0, 0}, {0, -step, 0});
            add(NameKind::Interior, middle, one_c, {step / 2, 0, 0}, {step - step / 2, 1, 0});
        }
    }
    for (const int finer : {1, 2}) {  // at the border of each level, and below the first
        cases.push_back(begin(finer == 1 ? "one_finer" : "two_finer", {64, 64, 4, finer, {}}));
        for (int level = 0; level < 8; ++level) {
            for (const int32_t beside : {0, 1}) {
                const int32_t step =
                    limited(profile().sweep_data, (int64_t{data(1)} << level) + beside);
                add(NameKind::Interior, middle, one_c, {step, 0, 0}, {0, -step, 0});
                add(NameKind::Edge, middle, one_c, {0, step, 0}, {});
            }
        }
    }
    cases.push_back(begin("turned_by_c", {64, 64, 6, 0, {}}));  // U D_c takes what D gives
    for (const int32_t c : {one_c, one_c / 2, one_c / 3}) {
        add(NameKind::Interior, middle, c, {data(20), data(30), one_c}, {data(20), 0, one_c / 2});
        add(NameKind::Interior, middle, c, {0, 0, one_c / 5}, {0, 0, -one_c / 5});
    }
    cases.push_back(begin("c_not_positive", {64, 64, 6, 0, {}}));  // w at its clamp, rounded away
    for (const int32_t c : {0, -1, -most_c, 1, 2}) {
        add(NameKind::Interior, middle, c, {1, -1, 0}, {0, 0, 1});
        add(NameKind::Edge, middle, c, {1, -1, 0}, {0, 0, 0});
    }
    cases.push_back(begin("saturates", {64, 64, 6, 0, {}}));
    for (const int32_t c : {one_c, 1}) {
        add(NameKind::Interior, {limited(profile().uv, INT64_MAX), 0}, c, {most, most, -most_c},
            {-most - 1, -most - 1, most_c});
        add(NameKind::Edge, {0, limited(profile().uv, INT64_MIN)}, c, {-most - 1, 0, -most_c}, {});
    }
    cases.push_back(begin("one_texel", {1, 1, 0, 0, {}}));
    add(NameKind::Interior, {0, 0}, one_c, {data(3), 0, 0}, {0, data(3), 0});
    cases.push_back(begin("long_map", {64, 1, 6, 0, {}}));  // higher than wide, and the other way
    add(NameKind::Interior, middle, one_c, {data(9), 0, 0}, {0, data(60), 0});
    cases.push_back(begin("tall_map", {1, 64, 6, 0, {}}));
    add(NameKind::Edge, middle, one_c, {data(60), data(9), 0}, {});

    const auto far = static_cast<int32_t>(profile().position.max_raw());
    const auto up = static_cast<int32_t>(profile().normal.max_raw());
    cases.push_back(begin("back", {64, 64, 6, 0, {far, -far - 1, 5}}));
    for (const int32_t z : {4, 5, 6}) {  // behind the plane through the eye, in it, before it
        for (const int32_t n : {up, -up - 1, 0}) {
            In in;
            in.p = {far, -far - 1, z};
            in.n = {up, up, n};
            cases.back().add(in);
            in.p = {-far - 1, far, z};
            cases.back().add(in);
        }
    }
    return cases;
}

Scenario FootprintModel::random(Random& random, std::size_t count) const {
    const auto size = [&] {
        return 1 + static_cast<int>(random.below(static_cast<uint32_t>(most_texels())) >>
                                    random.below(14));
    };
    Registers registers;
    registers.map_width = size(), registers.map_height = size();
    registers.last_level = static_cast<int>(random.below(kMostLevels + 1));
    registers.finer = static_cast<int>(random.below(kMostFiner + 1));
    registers.eye = {any_raw(random, profile().position), any_raw(random, profile().position),
                     any_raw(random, profile().position)};
    Scenario s = begin("random", registers);
    s.inputs.reserve(count * inputs());
    const Format &data = profile().sweep_data, &inverse_w = profile().inverse_w;
    for (std::size_t i = 0; i < count; ++i) {
        In in;
        in.kind = static_cast<NameKind>(random.percent(70) ? 2 : random.below(3));
        for (int32_t* p : {&in.p.x, &in.p.y, &in.p.z}) *p = any_raw(random, profile().position);
        for (int32_t* n : {&in.n.x, &in.n.y, &in.n.z}) *n = any_raw(random, profile().normal);
        if (random.percent(20)) in.p = registers.eye, in.p.x += in.p.x < 0 ? 1 : -1;
        in.u = {any_raw(random, profile().uv), any_raw(random, profile().uv)};
        in.c = static_cast<int32_t>(random.of_any_length(inverse_w.width - 1));
        if (random.percent(2)) in.c = -in.c;
        for (TexelStep<int32_t>& step : in.steps) {
            step = {any_raw(random, data), any_raw(random, data), any_raw(random, inverse_w)};
            if (random.percent(40)) continue;
            // What a walk asks for: U and its step in proportion to c, and c changes little.
            const int64_t least = std::max(in.c, 1);
            step.c = limited(inverse_w, random.between(-least / 8, least / 8));
            const auto near = [&](int32_t u) {
                const int shift = profile().uv.frac + inverse_w.frac - data.frac;
                const int64_t turned = Fixed::align(Fixed::mul(u, step.c), -shift);
                return limited(data, turned + any_raw(random, data) / 16);
            };
            step.u = near(in.u.x), step.v = near(in.u.y);
        }
        s.add(in);
    }
    return s;
}

/// U, a step of it and one of c along x for every c that there is, on edges and inside; with other
/// steps along y, and other positions and normals. 64 values of c, two kinds.
Scenario FootprintModel::exhaustive(uint64_t portion) const {
    if (portion >= 128) return {};
    const auto part = static_cast<int32_t>(portion);
    Registers registers{
        3, 2, 2, part % (kMostFiner + 1), {part % 16 - 8, part / 8 - 8, part % 5 - 2}};
    Scenario s = begin("exhaustive", registers);
    for (int32_t i = 0; i < 1 << 17; ++i) {
        const auto word = [](int32_t bits, int width) {
            return (bits & ((1 << width) - 1)) - (1 << (width - 1));
        };
        In in;
        in.kind = portion < 64 ? NameKind::Edge : NameKind::Interior;
        in.c = word(part, 6);
        in.u = {word(i, 5), word(i >> 3, 5)};
        in.steps[0] = {word(i >> 5, 6), word((i >> 5) + part, 6), word(i >> 11, 6)};
        in.steps[1] = {word(part / 3, 6) / 4, word(i, 6), word(part, 4)};
        in.p = {word(i, 4), word(i >> 4, 4), word(i >> 7, 4)};
        in.n = {word(i >> 8, 3), word(i >> 11, 3), word(i >> 14, 3)};
        s.add(in);
    }
    return s;
}

}  // namespace

std::unique_ptr<UnitModel> make_footprint_model(const Profile& profile) {
    return std::make_unique<FootprintModel>(profile);
}

}  // namespace repousse::cosim
