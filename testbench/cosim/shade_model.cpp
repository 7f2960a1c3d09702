#include <algorithm>
#include <array>
#include <cmath>

#include "datapath/numbers/policy.h"
#include "datapath/units/shade.h"
#include "datapath/units/shade_desc.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {
namespace {

using Registers = ShadeRegisters<Fixed>;
using Vector = Vec3<int32_t>;
using Rgb = Colour<int32_t>;

/// Visits every register in the order of the ports, as `visit(member)`; the elements of a vector
/// port stand last to first.
template <class AnyRegisters, class Visit>
void visit_registers(AnyRegisters& r, int lights, const Visit& visit) {
    visit(r.eye.x);
    visit(r.eye.y);
    visit(r.eye.z);
    visit(r.ambient.red);
    visit(r.ambient.green);
    visit(r.ambient.blue);
    const auto each = [&](auto Light<Fixed>::*part, auto component) {
        for (int i = lights; i-- > 0;) visit(r.lights[std::size_t(i)].*part.*component);
    };
    visit(r.shininess);
    visit(r.two_sided);
    each(&Light<Fixed>::direction, &Vector::x);
    each(&Light<Fixed>::direction, &Vector::y);
    each(&Light<Fixed>::direction, &Vector::z);
    for (const auto part : {&Light<Fixed>::diffuse, &Light<Fixed>::specular}) {
        each(part, &Rgb::red);
        each(part, &Rgb::green);
        each(part, &Rgb::blue);
    }
}

class ShadeModel : public UnitModel {
public:
    explicit ShadeModel(const Profile& profile) : UnitModel(profile, kShadeDesc), unit_(profile) {}

    const UnitDesc& desc() const override { return kShadeDesc; }
    uint64_t weight() const override { return 8; }
    uint64_t icarus_weight() const override { return 32; }
    std::vector<Scenario> hard_cases() const override;
    Scenario random(Random& random, std::size_t count) const override;
    Scenario exhaustive(uint64_t portion) const override;

    void evaluate(const Scenario& scenario, std::vector<int64_t>& outputs) override {
        Registers r;
        std::size_t at = 0;
        visit_registers(r, profile().lights, [&](auto& member) {
            member = static_cast<std::decay_t<decltype(member)>>(scenario.config.at(at++));
        });
        unit_.configure(r);
        outputs.clear();
        for (std::size_t i = 0; i < scenario.inputs.size(); i += inputs()) {
            const auto word = [&](std::size_t k) { return int32_t(scenario.inputs[i + k]); };
            const Rgb c = unit_({word(0), word(1), word(2)}, {word(3), word(4), word(5)});
            outputs.insert(outputs.end(), {c.red, c.green, c.blue});
        }
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
    int32_t one() const { return 1 << profile().normal.frac; }
    int32_t most() const { return static_cast<int32_t>(profile().normal.max_raw()); }
    int32_t least() const { return static_cast<int32_t>(profile().normal.min_raw()); }
    int32_t white() const { return 1 << profile().light.frac; }
    int32_t brightest() const { return static_cast<int32_t>(profile().light.max_raw()); }

    Scenario scenario(const char* name, const Registers& r) const {
        Scenario s{name, {}, nullptr, {}};
        visit_registers(r, profile().lights,
                        [&](const auto& member) { s.config.push_back(member); });
        return s;
    }
    static void add_at(Scenario& s, const Vector& p, const Vector& n) {
        s.inputs.insert(s.inputs.end(), {p.x, p.y, p.z, n.x, n.y, n.z});
    }
    /// With the eye at the origin: a vertex that sees it in direction v.
    void add(Scenario& s, const Vector& n, const Vector& v) const {
        add_at(s, {place(-v.x), place(-v.y), place(-v.z)}, n);
    }
    /// The nearest position that the format has.
    int32_t place(int64_t x) const {
        return static_cast<int32_t>(
            std::clamp(x, profile().position.min_raw(), profile().position.max_raw()));
    }
    Vector unit_vector(double x, double y, double z) const {
        const double scale = std::ldexp(1.0, profile().normal.frac) / std::hypot(x, y, z);
        const auto raw = [&](double c) {
            return static_cast<int32_t>(
                std::clamp(std::floor(c * scale + 0.5), double(least()), double(most())));
        };
        return {raw(x), raw(y), raw(z)};
    }
    Vector direction(Random& random) const {
        const auto c = [&] { return double(random.between(-(1 << 20), 1 << 20)) + 0.5; };
        const double x = c(), y = c();
        return unit_vector(x, y, c());
    }
    Vector any_vector(Random& random) const {
        const auto c = [&] { return static_cast<int32_t>(random.between(least(), most())); };
        const int32_t x = c(), y = c();
        return {x, y, c()};
    }
    /// One light along z.
    Registers from_above(int32_t diffuse, int32_t specular, int shininess) const {
        Registers r;
        r.shininess = shininess;
        r.lights[0] = {{0, 0, one()}, {diffuse, diffuse / 2, 0}, {specular, 0, specular / 2}};
        return r;
    }

    std::vector<Scenario> view_cases() const;

    Shade<Fixed> unit_;
};

// The way from the vertex to the eye, of every length that positions can be apart.
std::vector<Scenario> ShadeModel::view_cases() const {
    std::vector<Scenario> cases;
    const Vector up{0, 0, one()};
    Registers r = from_above(white() / 4, white() / 2, 20);
    cases.push_back(scenario("every_distance", r));
    for (int bits = 0; bits < profile().position.width; ++bits) {
        for (const int64_t sign : {1, -1}) {
            const int64_t d = sign * ((int64_t{1} << bits) + bits % 3 - 1);
            add_at(cases.back(), {place(d / 5), place(d / 3), place(-d)}, up);
        }
    }
    // Differences one bit longer than a position, and the longest negative one, -2^width + 1.
    for (const bool low : {false, true}) {
        const int32_t here = place(low ? INT64_MIN : INT64_MAX);
        const int32_t there = place(low ? INT64_MAX : INT64_MIN);
        r.eye = {here, there, here};
        cases.push_back(scenario("across_the_world", r));
        for (const int32_t x : {here, there, 0}) {
            for (const int32_t y : {here, there, 0}) {
                add_at(cases.back(), {x, y, there}, up);
            }
        }
    }
    return cases;
}

std::vector<Scenario> ShadeModel::hard_cases() const {
    std::vector<Scenario> cases = view_cases();
    const Vector up{0, 0, one()}, down{0, 0, -one()}, east{one(), 0, 0};

    // The highlight's whole profile: V turns away from the mirrored light.
    for (const int n : {1, 2, 3, 10, 64, 127, 128, 255}) {
        cases.push_back(scenario("every_exponent", from_above(white() / 4, white() / 2, n)));
        for (int i = 0; i <= 32; ++i) {
            const double angle = 1.5707963 * i * i / (32.0 * 32.0);
            add(cases.back(), up, unit_vector(std::sin(angle), 0, std::cos(angle)));
        }
    }
    for (const bool two_sided : {false, true}) {
        Registers r = from_above(white() / 2, white() / 2, 5);
        r.ambient = {white() / 4, white() / 8, 1};
        r.two_sided = two_sided;
        cases.push_back(scenario(two_sided ? "two_sided" : "behind_the_surface", r));
        for (const Vector& n : {up, down, east}) {
            for (const Vector& v : {up, down, east}) add(cases.back(), n, v);
        }
        for (int32_t tilt = -3; tilt <= 3; ++tilt) {
            add(cases.back(), {one(), 0, tilt}, {one(), 0, 0});
            add(cases.back(), {tilt, one(), 0}, {one(), 0, 0});
            add(cases.back(), {one(), 0, tilt}, {-one(), 0, tilt});
        }
    }
    cases.push_back(scenario("vectors_without_direction", from_above(white(), white(), 1)));
    for (const Vector& a : {up, down, east, Vector{}}) {
        add(cases.back(), a, {});
        add(cases.back(), {}, a);
    }
    cases.push_back(scenario("rounded_lengths", from_above(white() / 2, white() / 2, 128)));
    for (int32_t off = -16; off <= 16; ++off) add(cases.back(), {0, 0, one() + off}, up);
    cases.push_back(scenario("largest_products", from_above(brightest(), brightest(), 1)));
    for (const int32_t a : {most(), least(), -most(), 0}) {
        for (const int32_t b : {most(), least(), -most(), 0}) {
            add(cases.back(), {a, b, a}, {b, a, b});
            add(cases.back(), {a, a, b}, {a, b, b});
        }
    }
    Registers all;
    all.ambient = {brightest(), brightest(), 0};
    all.shininess = 2;
    for (auto& l : all.lights) {
        l = {up, {brightest(), 0, 1}, {brightest(), 1, 0}};
    }
    cases.push_back(scenario("all_lights_saturate", all));
    for (const Vector& n : {up, down, east}) add(cases.back(), n, up);

    // A light of its own colour from each side.
    Registers apart;
    apart.shininess = 20;
    for (int i = 0; i < profile().lights; ++i) {
        const double angle = 6.2831853 * i / profile().lights;
        auto& l = apart.lights[std::size_t(i)];
        l.direction = unit_vector(std::cos(angle), std::sin(angle), 0.5);
        l.diffuse = {white() >> (i % 4), white() >> ((i + 1) % 4), white() >> ((i + 2) % 4)};
        l.specular = {1 << (i % 4), white() / 8, white() >> (i % 3)};
    }
    cases.push_back(scenario("lights_apart", apart));
    for (int i = 0; i < 32; ++i) {
        const double angle = 6.2831853 * i / 32;
        add(cases.back(), unit_vector(std::cos(angle), std::sin(angle), 1), up);
    }
    return cases;
}

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
            return place(eye - (x << distance >> profile().normal.frac));
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
