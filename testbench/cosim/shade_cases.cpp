#include "testbench/cosim/shade_cases.h"

namespace repousse::cosim {
namespace {

class ShadeCases : private ShadeScenarios {
public:
    using ShadeScenarios::ShadeScenarios;

    std::vector<Scenario> view_cases() const;
    std::vector<Scenario> light_cases() const;
};

// The way from the vertex to the eye, of every length that positions can be apart.
std::vector<Scenario> ShadeCases::view_cases() const {
    std::vector<Scenario> cases;
    const Vector up{0, 0, one()};
    Registers r = from_above(white() / 4, white() / 2, 20);
    cases.push_back(scenario("every_distance", r));
    for (int bits = 0; bits < profile_.position.width; ++bits) {
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

std::vector<Scenario> ShadeCases::light_cases() const {
    std::vector<Scenario> cases;
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
    for (int i = 0; i < profile_.lights; ++i) {
        const double angle = 6.2831853 * i / profile_.lights;
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

}  // namespace

std::vector<Scenario> shade_cases(const Profile& profile) {
    const ShadeCases writer(profile);
    std::vector<Scenario> cases = writer.view_cases();
    for (Scenario& s : writer.light_cases()) cases.push_back(std::move(s));
    return cases;
}

}  // namespace repousse::cosim
