#include <array>

#include "datapath/numbers/policy.h"
#include "datapath/units/shade.h"
#include "datapath/units/shade_desc.h"
#include "testbench/cosim/shade_cases.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

class ShadeModel : public UnitModel, private ShadeScenarios {
public:
    explicit ShadeModel(const Profile& profile)
        : UnitModel(profile, kShadeDesc), ShadeScenarios(profile), unit_(profile) {}

    const UnitDesc& desc() const override { return kShadeDesc; }
    uint64_t weight() const override { return 8; }
    uint64_t icarus_weight() const override { return 32; }
    std::vector<Scenario> hard_cases() const override { return shade_cases(profile()); }
    Scenario random(Random& random, std::size_t count) const override;
    Scenario exhaustive(uint64_t portion) const override;

    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override {
        Registers r;
        std::size_t at = 0;
        visit_shade_registers(r, profile().lights, [&](auto& member) {
            member = static_cast<std::decay_t<decltype(member)>>(scenario.config.at(at++));
        });
        unit_.configure(r);
        answer_each(scenario, outputs, [this](const Word* in) {
            const auto word = [in](std::size_t k) { return static_cast<int32_t>(in[k]); };
            const Rgb c = unit_({word(0), word(1), word(2)}, {word(3), word(4), word(5)});
            return std::array<Word, 3>{c.red, c.green, c.blue};
        });
    }

    std::unique_ptr<UnitModel> with(const Profile& profile) const override {
        return make_shade_model(profile);
    }

    /// Components of four bits: every normal in every place, under one light.
    Profile tiny_profile() const override {
        Profile tiny = profile();
        tiny.position.width = 4, tiny.position.frac = 0;
        tiny.unnormalised.width = 7, tiny.unnormalised.frac = 4;
        tiny.normal.width = 4, tiny.normal.frac = 2;
        tiny.cosine.width = 7, tiny.cosine.frac = 5;
        tiny.light.width = 5, tiny.light.frac = 4;
        tiny.colour.width = 6, tiny.colour.frac = 6;
        tiny.lights = 1;
        tiny.power_log_index_bits = 2;
        tiny.power_exp_index_bits = 2;
        return tiny;
    }

private:
    Shade<Fixed> unit_;
};

// Half of the normals lie near the mirror's position for the first light, where powers are large.
Scenario ShadeModel::random(Random& random, std::size_t count) const {
    Registers r;
    // The eye and what it sees stay in the inner half of the world, but for some of each.
    const int reach = profile().position.width - 2;
    const auto anywhere = [&] {
        const auto c = [&] {
            return static_cast<int32_t>(
                random.between(profile().position.min_raw(), profile().position.max_raw()));
        };
        const int32_t x = c(), y = c();
        return Vector{x, y, c()};
    };
    r.eye = anywhere();
    if (random.percent(80)) r.eye = {r.eye.x / 4, r.eye.y / 4, r.eye.z / 4};
    const auto seen_from = [&](const Vector& v) {
        const int distance = static_cast<int>(random.between(0, reach));
        const auto c = [&](int64_t eye, int64_t x) {
            return place(eye - (x * (int64_t{1} << distance) >> profile().normal.frac));
        };
        return Vector{c(r.eye.x, v.x), c(r.eye.y, v.y), c(r.eye.z, v.z)};
    };
    const auto colour = [&] {
        const int bits = profile().light.width - 1;
        const auto c = [&] { return static_cast<int32_t>(random.of_any_length(bits)); };
        const int32_t red = c(), green = c();
        return Rgb{red, green, c()};
    };
    r.ambient = colour();
    r.shininess = random.percent(10) ? 255 : static_cast<int>(random.between(1, 128));
    r.two_sided = random.percent(50);
    for (int i = 0; i < profile().lights; ++i) {
        Light<Fixed>& l = r.lights[std::size_t(i)];
        l.direction = random.percent(90) ? direction(random) : any_vector(random);
        l.diffuse = colour();
        l.specular = colour();
    }
    Scenario s = scenario("random", r);
    s.inputs.reserve(count * inputs());
    for (std::size_t i = 0; i < count; ++i) {
        if (random.percent(5)) {
            const Vector p = anywhere();
            add_at(s, p, any_vector(random));
            continue;
        }
        const Vector v = direction(random);
        Vector n = direction(random);
        if (random.percent(50)) {
            const Vector& l = r.lights[0].direction;
            const double part = 0.125 / (1 + random.below(8));
            n = unit_vector(v.x + l.x + part * n.x, v.y + l.y + part * n.y, v.z + l.z + part * n.z);
        }
        add_at(s, seen_from(v), n);
    }
    return s;
}

Scenario ShadeModel::exhaustive(uint64_t portion) const {
    if (portion >= 16) return {};
    Registers r = from_above(white(), white(), static_cast<int>(1 + portion * portion));
    r.lights[0].direction = {int32_t(portion % 3) - 1, int32_t(portion / 3 % 3) - 1, 3};
    r.ambient = {int32_t(portion), 0, 1};
    r.two_sided = portion % 2 != 0;
    r.eye = {int32_t(portion) - 8, int32_t(portion % 5), -int32_t(portion % 3)};
    Scenario s = scenario("exhaustive", r);
    s.inputs.reserve(inputs() << 20);
    for (uint32_t bits = 0; bits < 1U << 20; ++bits) {
        const auto nibble = [bits](int k) { return int32_t(bits >> (4 * k) & 15U) - 8; };
        add_at(s, {nibble(2), nibble(3), nibble(4)}, {nibble(0), nibble(1), int32_t(portion) - 8});
    }
    return s;
}

}  // namespace

std::unique_ptr<UnitModel> make_shade_model(const Profile& profile) {
    return std::make_unique<ShadeModel>(profile);
}

}  // namespace repousse::cosim
