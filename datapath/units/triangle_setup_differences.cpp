// Steps 5 and 6 of the setup: what vertex data advance by, along edges and inside.

#include "datapath/units/triangle_setup.h"

#include "datapath/numbers/divide.h"

namespace repousse {

// Rounded differences, half up, with the guard bits: a numerator of at most 49 bits and 13 more.
int64_t TriangleSetup::rounded_quotient(int64_t numerator, int64_t divisor) const {
    const int64_t scaled = numerator * (int64_t{2} << options_.guard_bits);
    return floor_divide(scaled + divisor, 2 * divisor);
}

// Step 5, inside. Differences of data have 33 bits, so a numerator has 49.
void TriangleSetup::set_gradients(SweepTriangle& out, const Frame& frame) const {
    const auto [a, b, c] = frame.abc;
    const int32_t sb = frame.s[index(b)] - frame.s[index(a)];
    const int32_t sc = frame.s[index(c)] - frame.s[index(a)];
    const int32_t yb = frame.y[index(b)] - frame.y[index(a)];
    const int32_t yc = frame.y[index(c)] - frame.y[index(a)];
    SweepVector &sweep = out.sweep_difference, &side = out.side_difference;
    sweep = side = {};
    if (out.determinant == 0) return;
    sweep.modulus = side.modulus = 2 * out.determinant;
    for (std::size_t i = 0; i < index(out.components); ++i) {
        const int64_t xa = out.corners[index(a)].data[i];
        const int64_t xb = out.corners[index(b)].data[i] - xa;
        const int64_t xc = out.corners[index(c)].data[i] - xa;
        const int64_t sweep_numerator = xb * yc - xc * yb, side_numerator = xc * sb - xb * sc;
        if (options_.adder == AdderKind::Exact) {
            divide(sweep_numerator, out.determinant, sweep.value[i], sweep.remainder[i]);
            divide(side_numerator, out.determinant, side.value[i], side.remainder[i]);
        } else {
            sweep.value[i] = rounded_quotient(sweep_numerator, out.determinant);
            side.value[i] = rounded_quotient(side_numerator, out.determinant);
        }
    }
}

// Step 5, along an edge in the direction in which it is walked. The canonical kind rounds in the
// canonical direction, then turns round: -round(x) is not round(-x) at a tie.
SweepVector TriangleSetup::edge_difference(const SweepTriangle& out, int from, int to,
                                           int32_t steps) const {
    SweepVector vector;
    vector.modulus = 2 * steps;
    const bool turn = options_.adder == AdderKind::Canonical && !is_canonical(out, from, to);
    for (std::size_t i = 0; i < index(out.components); ++i) {
        const int64_t d =
            static_cast<int64_t>(out.corners[index(to)].data[i]) - out.corners[index(from)].data[i];
        if (options_.adder == AdderKind::Exact) {
            divide(d, steps, vector.value[i], vector.remainder[i]);
        } else {
            vector.value[i] = turn ? -rounded_quotient(-d, steps) : rounded_quotient(d, steps);
        }
    }
    return vector;
}

// What the accumulator holds at `from`. The canonical kind walking towards its origin starts where
// it would have arrived: to - steps * difference.
SweepVector TriangleSetup::edge_start(const SweepTriangle& out, int from, int to, int32_t steps,
                                      const SweepVector& difference) const {
    SweepVector vector;
    vector.modulus = 2 * steps;
    const bool backwards = options_.adder == AdderKind::Canonical && !is_canonical(out, from, to);
    const int64_t unit = int64_t{1} << options_.guard_bits;
    for (std::size_t i = 0; i < index(out.components); ++i) {
        if (options_.adder == AdderKind::Exact) {
            vector.value[i] = out.corners[index(from)].data[i];
            vector.remainder[i] = steps;
        } else if (backwards) {
            vector.value[i] = out.corners[index(to)].data[i] * unit - steps * difference.value[i];
        } else {
            vector.value[i] = out.corners[index(from)].data[i] * unit;
        }
    }
    return vector;
}

// Step 6. Edges never saturate: two ends of n >= 2 steps, the least with a vertex between them,
// differ by n / 2 times the format's range at most. A step inside a sliver may.
template <class Numerator>
TexelStep<int32_t> TriangleSetup::texel_step(Numerator&& numerator, int64_t divisor) const {
    const auto quotient = [&](std::size_t component, int bits) {
        const int64_t high = (int64_t{1} << (bits - 1)) - 1;
        int64_t q = numerator(component) / divisor;
        q = q > high ? high : q;
        q = q < ~high ? ~high : q;
        return static_cast<int32_t>(q);
    };
    constexpr std::size_t kTexture = 6;
    return {quotient(kTexture, options_.data_bits), quotient(kTexture + 1, options_.data_bits),
            quotient(kInverseWComponent, options_.c_bits)};
}

void TriangleSetup::set_texel_steps(SweepTriangle& out, const Frame& frame) const {
    const auto difference = [&out](int from, int to, std::size_t i) {
        return int64_t{out.corners[index(to)].data[i]} - out.corners[index(from)].data[i];
    };
    out.texel_steps = {};
    for (int e = 0; e < 3; ++e) {
        const int next = (e + 1) % 3;
        const bool canonical = is_canonical(out, e, next);
        const int from = canonical ? e : next, to = canonical ? next : e;
        out.texel_steps.edges[index(e)] =
            texel_step([&](std::size_t i) { return difference(from, to, i); },
                       at_least_one(frame.steps[index(e)]));
    }
    if (out.determinant == 0) return;
    const auto [a, b, c] = frame.abc;
    const int32_t sb = frame.s[index(b)] - frame.s[index(a)];
    const int32_t sc = frame.s[index(c)] - frame.s[index(a)];
    const int32_t yb = frame.y[index(b)] - frame.y[index(a)];
    const int32_t yc = frame.y[index(c)] - frame.y[index(a)];
    out.texel_steps.sweep = texel_step(
        [&, a = a, b = b, c = c](std::size_t i) {
            return difference(a, b, i) * yc - difference(a, c, i) * yb;
        },
        out.determinant);
    out.texel_steps.side = texel_step(
        [&, a = a, b = b, c = c](std::size_t i) {
            return difference(a, c, i) * sb - difference(a, b, i) * sc;
        },
        out.determinant);
}

}  // namespace repousse
