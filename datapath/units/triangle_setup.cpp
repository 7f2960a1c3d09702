#include "datapath/units/triangle_setup.h"

#include <cstddef>

#include "datapath/numbers/divide.h"

namespace repousse {
namespace {

SlotStep slot_step(int32_t difference, int32_t steps) {
    int64_t quotient = 0;
    SlotStep step;
    divide(difference, steps, quotient, step.remainder);
    step.quotient = static_cast<int32_t>(quotient);
    return step;
}

// Edge e joins corners e and (e+1)%3.
int edge_between(int p, int q) { return (p + 1) % 3 == q ? p : q; }

}  // namespace

// Half an LSB is 1 << (bits - 1); the clamp is two statements. 22 bits in, 14 out.
std::array<int32_t, 3> TriangleSetup::slot(const std::array<int32_t, 3>& position) {
    std::array<int32_t, 3> out{};
    bool moved = false;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        int32_t x = (position[axis] + (1 << (kGridFractionBits - 1))) >> kGridFractionBits;
        x -= axis == 2 ? registers_.z_offset : 0;
        int32_t clamped = x > registers_.guard ? registers_.guard : x;
        clamped = clamped < -registers_.guard ? -registers_.guard : clamped;
        moved |= clamped != x;
        out[axis] = clamped;
    }
    counters_.clamped += moved;
    return out;
}

// Steps 2 and 3. False if all corners share a grid point.
bool TriangleSetup::choose_plane(SweepTriangle& out, Frame& frame) const {
    std::array<uint8_t, 3> direction{};
    for (std::size_t e = 0; e < 3; ++e) {
        const auto &p = out.corners[e].slot, &q = out.corners[(e + 1) % 3].slot;
        for (uint8_t axis = 0; axis < 3; ++axis) {
            const int32_t d = q[axis] < p[axis] ? p[axis] - q[axis] : q[axis] - p[axis];
            if (d > frame.steps[e]) frame.steps[e] = d, direction[e] = axis;
        }
    }
    uint8_t primary = 0;
    for (uint8_t e = 1; e < 3; ++e) {
        if (frame.steps[e] > frame.steps[primary]) primary = e;
    }
    out.primary = primary;
    out.primary_steps = at_least_one(frame.steps[primary]);
    int a = primary, b = (primary + 1) % 3;
    const int c = (primary + 2) % 3;
    if (frame.steps[primary] == 0) return false;

    const std::size_t sweep = direction[primary];
    if (out.corners[index(a)].slot[sweep] > out.corners[index(b)].slot[sweep]) {
        const int swapped = a;
        a = b;
        b = swapped;
        frame.odd = true;
    }
    frame.abc = {a, b, c};
    const auto &pa = out.corners[index(a)].slot, &pb = out.corners[index(b)].slot,
               &pc = out.corners[index(c)].slot;
    // Products of s15 differences are 29 bits, but D is twice an area within a square of 2^13: 26.
    const auto determinant = [&](std::size_t side) {
        return (pb[sweep] - pa[sweep]) * (pc[side] - pa[side]) -
               (pb[side] - pa[side]) * (pc[sweep] - pa[sweep]);
    };
    const std::size_t low = sweep == 0 ? 1 : 0, high = sweep == 2 ? 1 : 2;
    const int32_t d_low = determinant(low), d_high = determinant(high);
    const int32_t size_low = d_low < 0 ? -d_low : d_low, size_high = d_high < 0 ? -d_high : d_high;
    const bool take_high = size_high > size_low;
    const std::size_t side = take_high ? high : low;
    out.sweep_axis = static_cast<uint8_t>(sweep);
    out.side_axis = static_cast<uint8_t>(side);
    out.mirror = (take_high ? d_high : d_low) < 0 ? -1 : 1;
    out.determinant = take_high ? size_high : size_low;
    for (std::size_t i = 0; i < 3; ++i) {
        frame.s[i] = out.corners[i].slot[sweep];
        frame.y[i] = out.mirror * out.corners[i].slot[side];
    }
    return true;
}

// Inside there is one origin, A, for both halves; the plain kind starts anew from B.
PrimaryWalk TriangleSetup::primary_walk(const SweepTriangle& out, const Frame& frame, int from,
                                        int to) const {
    PrimaryWalk walk;
    walk.edge = edge_walk(out, frame, from, to);
    walk.base.modulus = out.determinant == 0 ? 1 : 2 * out.determinant;
    const bool derived = options_.adder == AdderKind::Canonical && from != frame.abc[0];
    const int origin = derived ? to : from;
    const auto columns = static_cast<uint64_t>(derived ? walk.edge.steps : 0);
    const auto rows =
        static_cast<uint64_t>(static_cast<int64_t>(frame.y[index(from)]) - frame.y[index(origin)]);
    for (std::size_t i = 0; i < index(out.components); ++i) {
        const int64_t corner =
            out.corners[index(origin)].data[i] * (int64_t{1} << options_.guard_bits);
        walk.base.value[i] =
            static_cast<int64_t>(static_cast<uint64_t>(corner) +
                                 columns * static_cast<uint64_t>(out.sweep_difference.value[i]) +
                                 rows * static_cast<uint64_t>(out.side_difference.value[i]));
        walk.base.remainder[i] = options_.adder == AdderKind::Exact ? out.determinant : 0;
    }
    return walk;
}

EdgeWalk TriangleSetup::edge_walk(const SweepTriangle& out, const Frame& frame, int from,
                                  int to) const {
    EdgeWalk walk;
    walk.edge = static_cast<uint8_t>(edge_between(from, to));
    walk.from = static_cast<uint8_t>(from);
    walk.to = static_cast<uint8_t>(to);
    walk.steps = at_least_one(frame.steps[walk.edge]);
    const bool canonical = is_canonical(out, from, to);
    walk.name_step = canonical ? 1 : -1;
    walk.name_start = canonical ? 0 : walk.steps;
    walk.row = {frame.y[index(from)], walk.steps, 2 * walk.steps};
    walk.row_step = slot_step(frame.y[index(to)] - frame.y[index(from)], walk.steps);
    walk.difference = edge_difference(out, from, to, walk.steps);
    walk.start = edge_start(out, from, to, walk.steps, walk.difference);
    return walk;
}

// Step 4. A half without width is the other half's R5 edge, so it is walked from the primary edge
// to C whatever the case.
void TriangleSetup::set_halves(SweepTriangle& out, const Frame& frame) const {
    const auto [a, b, c] = frame.abc;
    const bool up_to_c = frame.y[index(c)] >= frame.y[index(a)];
    const bool up_from_c = frame.y[index(b)] > frame.y[index(c)];
    out.form = !up_to_c    ? SweepCase::Decreasing
               : up_from_c ? SweepCase::Increasing
                           : SweepCase::Roof;
    out.continues = out.form != SweepCase::Roof;
    std::array<std::array<int, 2>, 2> ends{};
    switch (out.form) {
        case SweepCase::Roof:
            ends = {{{a, c}, {b, c}}};
            break;
        case SweepCase::Increasing:
            ends = {{{a, c}, {c, b}}};
            break;
        case SweepCase::Decreasing:
            ends = {{{b, c}, {c, a}}};
            break;
    }
    for (std::size_t h = 0; h < 2; ++h) {
        SubTriangle& half = out.halves[h];
        half = {};
        auto [from, to] = ends[h];
        const int32_t width = frame.s[index(to)] - frame.s[index(from)];
        if (width == 0 && from == c) {
            from = to;
            to = c;
        }
        half.edge = edge_walk(out, frame, from, to);
        half.columns = width < 0 ? -width : width;
        half.column_step = slot_step(half.columns, half.edge.steps);
        half.direction = width < 0 ? -1 : 1;
        half.flip = frame.odd != (width < 0);
        half.tip = from != c;
        half.closing = to != c;
    }
    for (std::size_t h = 0; h < 2; ++h) {
        if (out.halves[1 - h].columns != 0) continue;
        out.halves[h].other_left = !out.halves[h].tip;
        out.halves[h].other_right = !out.halves[h].closing;
    }
}

void TriangleSetup::set_primary(SweepTriangle& out, const Frame& frame) const {
    const int a = frame.abc[0], b = frame.abc[1];
    const bool from_b = out.form == SweepCase::Decreasing;
    out.walks[0] = primary_walk(out, frame, from_b ? b : a, from_b ? a : b);
    out.walks[1] = out.continues ? PrimaryWalk{} : primary_walk(out, frame, b, a);
}

void TriangleSetup::operator()(const std::array<SweepCorner, 3>& corners, SweepTriangle& out) {
    ++counters_.items;
    out.corners = corners;
    out.components = options_.components;
    out.guard_bits = options_.guard_bits;
    Frame frame;
    out.single = !choose_plane(out, frame);
    if (out.single) {
        ++counters_.single;
        return;
    }
    counters_.collinear += out.determinant == 0;
    set_halves(out, frame);
    set_gradients(out, frame);
    set_primary(out, frame);
    if (options_.footprints) set_texel_steps(out, frame);
    ++counters_.forms[static_cast<std::size_t>(out.form)];
    // Three edges and two gradients: a walk the other way only subtracts.
    counters_.divisions += 5 * static_cast<uint64_t>(out.components);

    const auto distance = [&](int p, int q) {
        const int32_t d = frame.y[index(p)] - frame.y[index(q)];
        return d < 0 ? -d : d;
    };
    const auto [a, b, c] = frame.abc;
    // 5 terms of at most 2^13, doubled: 17 bits.
    out.step_limit = static_cast<uint32_t>(
        2 * (distance(a, b) + distance(a, c) + frame.steps[0] + frame.steps[1] + frame.steps[2]) +
        16);
}

}  // namespace repousse
