#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "datapath/numbers/policy.h"
#include "datapath/units/shade.h"
#include "testbench/cosim/raw_words.h"
#include "testbench/cosim/unit_model.h"

namespace repousse::cosim {

/// Visits every register of shade in the order of the ports, as `visit(member)`; the elements of a
/// vector port stand last to first.
template <class AnyRegisters, class Visit>
void visit_shade_registers(AnyRegisters& r, int lights, const Visit& visit) {
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
    each(&Light<Fixed>::direction, &Vec3<int32_t>::x);
    each(&Light<Fixed>::direction, &Vec3<int32_t>::y);
    each(&Light<Fixed>::direction, &Vec3<int32_t>::z);
    for (const auto part : {&Light<Fixed>::diffuse, &Light<Fixed>::specular}) {
        each(part, &Colour<int32_t>::red);
        each(part, &Colour<int32_t>::green);
        each(part, &Colour<int32_t>::blue);
    }
}

/// What scenarios of shade are made of, in a profile's formats.
class ShadeScenarios {
public:
    explicit ShadeScenarios(const Profile& profile) : profile_(profile) {}

protected:
    using Registers = ShadeRegisters<Fixed>;
    using Vector = Vec3<int32_t>;
    using Rgb = Colour<int32_t>;

    int32_t one() const { return 1 << profile_.normal.frac; }
    int32_t most() const { return static_cast<int32_t>(profile_.normal.max_raw()); }
    int32_t least() const { return static_cast<int32_t>(profile_.normal.min_raw()); }
    int32_t white() const { return 1 << profile_.light.frac; }
    int32_t brightest() const { return static_cast<int32_t>(profile_.light.max_raw()); }

    Scenario scenario(const char* name, const Registers& r) const {
        Scenario s{name, {}, nullptr, {}};
        visit_shade_registers(r, profile_.lights,
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
    int32_t place(int64_t x) const { return limited(profile_.position, x); }
    Vector unit_vector(double x, double y, double z) const {
        const double scale = std::ldexp(1.0, profile_.normal.frac) / std::hypot(x, y, z);
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

    Profile profile_;
};

/// The hard cases of shade, by name.
std::vector<Scenario> shade_cases(const Profile& profile);

}  // namespace repousse::cosim
