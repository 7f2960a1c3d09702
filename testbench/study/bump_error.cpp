#include "testbench/study/bump_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "datapath/units/bump.h"
#include "testbench/host/map/normal_map.h"
#include "testbench/study/angles.h"
#include "testbench/study/paragraph.h"

namespace repousse::study {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// The texel in the middle of 3 x 3 heights, in the form of each kind.
struct Texel {
    std::array<uint16_t, 9> heights{};
    std::array<Vec3<int16_t>, 9> normals{};
    std::array<Turn<int16_t>, 9> turns{};
    glm::dvec3 exact;   ///< of the heights, any length
    glm::dvec3 stored;  ///< of what the kind stores
};

// Any heights, and texels of a size that makes slopes of at most 60 degrees.
Texel texel_of(const Profile& p, MapView<Fixed>& map, Dice& dice) {
    Texel texel;
    const auto most = static_cast<double>(p.height.max_raw());
    for (uint16_t& h : texel.heights) h = static_cast<uint16_t>(dice.real(0, most + 0.999));
    const double steepest = std::tan(kPi / 3);
    const auto slope = [&](SlopeScale<Fixed>& scale, int low, int high) {
        const double wanted = dice.real(0, steepest) / most;
        scale.exponent = kScaleBits - 1 - std::ilogb(wanted);
        scale.mantissa = static_cast<int32_t>(std::lround(std::ldexp(wanted, scale.exponent)));
        return (texel.heights[std::size_t(high)] - texel.heights[std::size_t(low)]) *
               std::ldexp(scale.mantissa, -scale.exponent);
    };
    texel.exact = {-slope(map.slope_u, 3, 5), -slope(map.slope_v, 1, 7), 1.0};
    const glm::dvec3 n = glm::normalize(texel.exact);
    const Vec3<int32_t> normal = to_raw(n, p.map_normal);
    texel.normals.fill({int16_t(normal.x), int16_t(normal.y), int16_t(normal.z)});
    const glm::dvec2 turn = host::turns_of(n);
    texel.turns.fill({int16_t(to_raw(turn.x, p.angle)), int16_t(to_raw(turn.y, p.angle))});
    const double a = kPi * std::ldexp(texel.turns[0].about_b, -p.angle.frac);
    const double b = kPi * std::ldexp(texel.turns[0].about_t, -p.angle.frac);
    texel.stored = p.bump_kind == 0   ? to_real(normal, p.map_normal)
                   : p.bump_kind == 1 ? texel.exact
                                      : glm::dvec3(std::sin(a), std::cos(a) * std::sin(b),
                                                   std::cos(a) * std::cos(b));
    return texel;
}

struct Frame {
    glm::dvec3 n, t;
    glm::dvec3 turned(const glm::dvec3& d) const {
        return t * d.x + glm::cross(n, t) * d.y + n * d.z;
    }
};

Frame frame_of(Dice& dice) {
    Frame frame{dice.direction(), {}};
    do {
        frame.t = glm::cross(frame.n, dice.direction());
    } while (glm::length(frame.t) < 0.1);
    frame.t = glm::normalize(frame.t);
    return frame;
}

/// Half-way to a frame turned by up to 30 degrees about any axis, N and T each normalised.
Frame interpolated(const Frame& from, Dice& dice) {
    const glm::dvec3 axis = dice.direction();
    const double angle = dice.real(0, kPi / 6);
    const auto turn = [&](const glm::dvec3& v) {
        return v * std::cos(angle) + glm::cross(axis, v) * std::sin(angle) +
               axis * (glm::dot(axis, v) * (1 - std::cos(angle)));
    };
    return {glm::normalize(from.n + turn(from.n)), glm::normalize(from.t + turn(from.t))};
}

}  // namespace

BumpError bump_error(const char* name, const Profile& p, int count, uint64_t seed) {
    BumpError e;
    e.profile = name;
    e.normalise_kind = p.normalise_kind;
    e.bump_kind = p.bump_kind;
    Bump<Fixed> unit(p);
    Dice dice(seed);
    MapView<Fixed> map;
    map.width = map.height = 3;
    double squares = 0, map_squares = 0;
    for (int i = 0; i < count; ++i) {
        const Texel texel = texel_of(p, map, dice);
        map.heights = texel.heights;
        map.normals = texel.normals;
        map.turns = texel.turns;
        unit.configure(map);
        const Frame frame = frame_of(dice);
        Vertex<Fixed> vertex;
        vertex.uv = {1 << p.uv.frac, 1 << p.uv.frac};
        vertex.normal = to_raw(frame.n, p.normal);
        vertex.tangent = to_raw(frame.t, p.normal);
        unit(vertex);
        // The reference starts from the same rounded frame.
        const Frame rounded{to_real(vertex.normal, p.normal), to_real(vertex.tangent, p.normal)};
        const glm::dvec3 found = to_real(vertex.displaced_normal, p.displaced_normal);
        const double own = angle_deg(found, rounded.turned(texel.stored));
        const double whole = angle_deg(found, rounded.turned(texel.exact));
        e.max_deg = std::max(e.max_deg, own);
        e.map_max_deg = std::max(e.map_max_deg, whole);
        squares += own * own;
        map_squares += whole * whole;
        const auto off = [&](const Frame& f) {
            return std::abs(glm::length(f.turned(texel.stored)) - 1);
        };
        e.square_length = std::max(e.square_length, off(rounded));
        e.mean_length = std::max(e.mean_length, off(interpolated(frame, dice)));
    }
    e.rms_deg = std::sqrt(squares / count);
    e.map_rms_deg = std::sqrt(map_squares / count);
    return e;
}

std::string bump_markdown(const std::vector<BumpError>& errors) {
    const char* kinds[] = {"stored normals", "differences of heights", "two angles"};
    std::string text =
        "\n## Bump: three kinds\n\n" +
        paragraph(
            "The same for N' of `bump`, by `bump_kind`, on slopes of up to 60 degrees in frames at "
            "right angles. The unit's own error is against double from the same texel; that of the "
            "map is against the normal of the heights, so that it holds what rounding a stored "
            "normal or angle adds. Heights need no such rounding.");
    text +=
        "| profile | `normalise_kind` | `bump_kind` | own max (degrees) | own rms | map max | map "
        "rms |\n|---|---|---|---|---|---|---|\n";
    for (const BumpError& e : errors) {
        text += fmt::format("| {} | {} | {} {} | {:.4f} | {:.4f} | {:.4f} | {:.4f} |\n", e.profile,
                            e.normalise_kind, e.bump_kind, kinds[e.bump_kind], e.max_deg, e.rms_deg,
                            e.map_max_deg, e.map_rms_deg);
    }
    double square = 0, mean = 0;
    for (const BumpError& e : errors) {
        if (e.bump_kind != 2 || e.profile != "default") continue;
        square = std::max(square, e.square_length);
        mean = std::max(mean, e.mean_length);
    }
    text +=
        "\n" +
        paragraph(fmt::format(
            "Two rotations keep the length: with `bump_kind` 2 in frames at right angles the "
            "vector before its normalisation is at most {:.2e} off one (`default`). Half-way "
            "between two frames up to 30 degrees apart, N and T being normalised one by one, it "
            "is up to {:.3f} off: interpolated frames are not at right angles. So kind 2 is "
            "normalised like the others.",
            square, mean));
    text.pop_back();  // the next section begins with an empty line
    return text;
}

}  // namespace repousse::study
