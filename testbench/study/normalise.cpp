#include "testbench/study/normalise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "datapath/units/mid_vertex.h"
#include "datapath/units/normalise.h"
#include "testbench/study/angles.h"
#include "testbench/study/bump_error.h"
#include "testbench/study/paragraph.h"
#include "tlm/config/profile_reader.h"

namespace repousse::study {
namespace {

/// Largest and root mean square of what `next` gives.
template <class Next>
NormaliseError gather(const char* profile, int kind, const char* what, Next next) {
    NormaliseError e{profile, kind, what, 0, 0};
    double squares = 0;
    for (int i = 0; i < NormaliseReport::kVectors; ++i) {
        const double angle = next();
        e.max_deg = std::max(e.max_deg, angle);
        squares += angle * angle;
    }
    e.rms_deg = std::sqrt(squares / NormaliseReport::kVectors);
    return e;
}

// Lengths of 1/8 to the largest one: what interpolation leaves of normals up to 165 degrees apart.
NormaliseError of_unit(const char* name, const Profile& p, uint64_t seed) {
    Normalise<Fixed> unit(p);
    Dice dice(seed);
    return gather(name, p.normalise_kind, "`normalise`, lengths of 1/8 to 1", [&] {
        const glm::dvec3 v = dice.direction() * dice.real(0.125, 1.0);
        return angle_deg(to_real(unit(to_raw(v, p.unnormalised)), p.normal), v);
    });
}

// The reference starts from the same rounded ends: the unit's own error. Ends at most 120 degrees
// apart, so that their sum is as long as they are.
NormaliseError of_midpoint(const char* name, const Profile& p, uint64_t seed) {
    MidVertex<Fixed> unit(p);
    Dice dice(seed);
    return gather(name, p.normalise_kind, "`mid_vertex`, N of ends up to 120 degrees apart", [&] {
        glm::dvec3 a, b;
        do {
            a = dice.direction(), b = dice.direction();
        } while (glm::dot(a, b) < -0.5);
        Vertex<Fixed> v1, v2, mid;
        v1.normal = v1.tangent = to_raw(a, p.normal);
        v2.normal = v2.tangent = to_raw(b, p.normal);
        unit.attributes(v1, v2, mid);
        return angle_deg(to_real(mid.normal, p.normal),
                         to_real(v1.normal, p.normal) + to_real(v2.normal, p.normal));
    });
}

ShortVectors of_length(const char* name, Profile p, double lsb, uint64_t seed) {
    ShortVectors row;
    row.profile = name;
    row.length_lsb = lsb;
    for (int kind = 0; kind < 2; ++kind) {
        p.normalise_kind = kind;
        Normalise<Fixed> unit(p);
        Dice dice(seed);
        for (int i = 0; i < 20'000; ++i) {
            const glm::dvec3 v = dice.direction() * std::ldexp(lsb, -p.unnormalised.frac);
            const Vec3<int32_t> raw = to_raw(v, p.unnormalised);
            if (raw == Vec3<int32_t>{}) continue;
            const double angle = angle_deg(to_real(unit(raw), p.normal), v);
            row.max_deg[kind] = std::max(row.max_deg[kind], angle);
        }
    }
    // Half an LSB in each component before: sqrt(3)/2 LSB at most at right angles to v, whose sine
    // that is. Behind: 3/4 LSB of `normal` in each component, which CORDIC needs not all of.
    const double before = std::asin(std::min(1.0, std::sqrt(3.0) / 2 / lsb));
    row.bound_deg = kDegrees * (before + std::ldexp(std::sqrt(3.0) * 0.75, -p.normal.frac));
    return row;
}

}  // namespace

NormaliseReport normalise_study(uint64_t seed) {
    NormaliseReport report;
    report.seed = seed;
    for (const char* name : {"default", "narrow"}) {
        Profile p = *shipped_profile(name);
        for (int kind = 0; kind < 2; ++kind) {
            p.normalise_kind = kind;
            report.errors.push_back(of_unit(name, p, seed));
            report.errors.push_back(of_midpoint(name, p, seed + 1));
        }
        for (const int normalise : {0, 1}) {
            for (const int kind : {0, 1, 2}) {
                p.normalise_kind = normalise;
                p.bump_kind = kind;
                report.bumps.push_back(bump_error(name, p, NormaliseReport::kVectors, seed + 2));
            }
        }
        for (const double lsb : {2.0, 4.0, 16.0, 64.0, 512.0, 4096.0}) {
            report.lengths.push_back(of_length(name, p, lsb, seed + 3));
        }
        report.cycles.push_back(
            {name, {normalise_latency(0, p.normal.frac), normalise_latency(1, p.normal.frac)}});
    }
    return report;
}

std::string normalise_markdown(const NormaliseReport& report) {
    const char* kinds[] = {"inverse square root", "CORDIC"};
    std::string text = "# Normalisation: error and cycles of both kinds\n\n";
    text += paragraph(
        "Made by `repousse study normalise -o docs/normalise.md`; no figure in it is typed by "
        "hand. "
        "The unit is described in units/normalise.md; a profile's `normalise_kind` chooses.");
    text +=
        "## Angular error\n\n" +
        paragraph(fmt::format(
            "The angle between the device's normal and the same in double, {} random vectors in "
            "each row, seed {}.",
            NormaliseReport::kVectors, report.seed));
    text += "| profile | kind | where | max (degrees) | rms (degrees) |\n|---|---|---|---|---|\n";
    for (const NormaliseError& e : report.errors) {
        text += fmt::format("| {} | {} {} | {} | {:.4f} | {:.4f} |\n", e.profile, e.kind,
                            kinds[e.kind], e.what, e.max_deg, e.rms_deg);
    }
    text += bump_markdown(report.bumps);
    text +=
        "\n## Short vectors\n\n" +
        paragraph(
            "Neither kind loses accuracy with the length of what it is given, down to one LSB: "
            "both begin with a count of leading zeros. What short vectors lack was rounded away "
            "before, when they were brought to `unnormalised`. The largest angle in degrees, "
            "that rounding included, of 20000 vectors of one length, and the bound asin(sqrt(3) "
            "/ 2 / length) + 0.75 sqrt(3) LSB of `normal`. A vector that rounds to zero has no "
            "direction and is counted.");
    text +=
        "| profile | length (LSB of `unnormalised`) | 0 inverse square root | 1 CORDIC | bound |\n"
        "|---|---|---|---|---|\n";
    for (const ShortVectors& s : report.lengths) {
        text += fmt::format("| {} | {:.0f} | {:.4f} | {:.4f} | {:.4f} |\n", s.profile, s.length_lsb,
                            s.max_deg[0], s.max_deg[1], s.bound_deg);
    }
    text +=
        "\n## Cycles\n\n| profile | 0 inverse square root: latency | 1 CORDIC: latency | "
        "interval of both |\n|---|---|---|---|\n";
    for (const NormaliseCycles& c : report.cycles) {
        text += fmt::format("| {} | {} | {} | 1 |\n", c.profile, c.latency[0], c.latency[1]);
    }
    return text;
}

}  // namespace repousse::study
