#include "datapath/sweep_line_ports.h"

#include <algorithm>
#include <cstddef>

namespace repousse {

// clang-format off
static_assert(ports_are(kSweepLineDesc, PortKind::Config, {"abort_all"}));
static_assert(ports_are(kSweepLineDesc, PortKind::Input, {
    "single", "continues", "mirrored", "sweep_start", "determinant", "step_limit",
    "half0_columns", "half0_down", "half0_flip", "half0_tip", "half0_closing",
    "half0_other_left", "half0_other_right", "half1_columns", "half1_down", "half1_flip",
    "half1_tip", "half1_closing", "half1_other_left", "half1_other_right", "walk0_edge",
    "walk0_from", "walk0_to", "walk0_backward", "walk0_steps", "walk0_row",
    "walk0_row_quotient", "walk0_row_rest", "walk1_edge", "walk1_from", "walk1_to",
    "walk1_backward", "walk1_steps", "walk1_row", "walk1_row_quotient", "walk1_row_rest",
    "edge0_edge", "edge0_from", "edge0_to", "edge0_backward", "edge0_steps", "edge0_row",
    "edge0_row_quotient", "edge0_row_rest", "edge1_edge", "edge1_from", "edge1_to",
    "edge1_backward", "edge1_steps", "edge1_row", "edge1_row_quotient", "edge1_row_rest",
    "corner0", "corner1", "corner2", "walk0_start", "walk0_step", "walk0_rest", "walk1_start",
    "walk1_step", "walk1_rest", "edge0_start", "edge0_step", "edge0_rest", "edge1_start",
    "edge1_step", "edge1_rest", "base0", "base1", "sweep_step", "sweep_rest", "side_step",
    "side_rest"}));
static_assert(ports_are(kSweepLineDesc, PortKind::Output, {
    "data3", "kind3", "part3", "a3", "b3", "data2", "kind2", "part2", "a2", "b2", "data1",
    "kind1", "part1", "a1", "b1", "data0", "kind0", "part0", "a0", "b0", "command3", "command2",
    "command1", "command0", "count", "vertex_count", "init", "flip", "runaway", "last"}));
// clang-format on

namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// The low bits of a value, as a signed number.
int64_t low_bits(int64_t value, int width) {
    const int spare = 64 - width;
    return static_cast<int64_t>(static_cast<uint64_t>(value) << spare) >> spare;
}

/// Words in the order of the ports; a vector's last element comes first.
class Packer {
public:
    explicit Packer(const Profile& profile)
        : components_(index(profile.components)),
          data_bits_(sweep_data_width(profile)),
          sum_bits_(data_bits_ + profile.guard_bits) {}

    template <class... T>
    void add(T... word) {
        (words_.push_back(static_cast<Word>(word)), ...);
    }
    void add_data(const std::array<int32_t, kSweepComponents>& data) {
        for (std::size_t i = components_; i-- > 0;) add(low_bits(data[i], data_bits_));
    }
    void add_value(const SweepVector& v) {
        for (std::size_t i = components_; i-- > 0;) add(low_bits(v.value[i], sum_bits_));
    }
    void add_rest(const SweepVector& v) {
        for (std::size_t i = components_; i-- > 0;) add(v.remainder[i]);
    }
    std::vector<Word> take() { return std::move(words_); }

private:
    std::size_t components_;
    int data_bits_, sum_bits_;
    std::vector<Word> words_;
};

/// The way back.
class Unpacker {
public:
    Unpacker(const Word* words, const Profile& profile)
        : words_(words),
          components_(index(profile.components)),
          exact_(profile.adder_kind == static_cast<int>(AdderKind::Exact)) {}

    template <class T>
    void take(T& field) {
        field = static_cast<T>(*words_++);
    }
    int32_t take() { return static_cast<int32_t>(*words_++); }
    void take_data(std::array<int32_t, kSweepComponents>& data) {
        for (std::size_t i = components_; i-- > 0;) take(data[i]);
    }
    /// Where an accumulator starts: half a modulus as remainder, if there are remainders.
    void take_start(SweepVector& v, int32_t divisor) {
        v.modulus = 2 * divisor;
        v.remainder.fill(exact_ ? divisor : 0);
        for (std::size_t i = components_; i-- > 0;) take(v.value[i]);
    }
    void take_difference(SweepVector& v, int32_t divisor) {
        v.modulus = 2 * divisor;
        for (std::size_t i = components_; i-- > 0;) take(v.value[i]);
        for (std::size_t i = components_; i-- > 0;) take(v.remainder[i]);
    }

private:
    const Word* words_;
    std::size_t components_;
    bool exact_;
};

void pack_half(const SubTriangle& h, Packer& packer) {
    packer.add(h.columns, h.direction < 0, h.flip, h.tip, h.closing, h.other_left, h.other_right);
}

void unpack_half(SubTriangle& h, Unpacker& unpacker) {
    unpacker.take(h.columns);
    h.direction = static_cast<int8_t>(unpacker.take() != 0 ? -1 : 1);
    unpacker.take(h.flip);
    unpacker.take(h.tip);
    unpacker.take(h.closing);
    unpacker.take(h.other_left);
    unpacker.take(h.other_right);
}

void pack_walk(const EdgeWalk& w, Packer& packer) {
    packer.add(w.edge, w.from, w.to, w.name_step < 0, w.steps, w.row.at, w.row_step.quotient,
               w.row_step.remainder);
}

void unpack_walk(EdgeWalk& w, Unpacker& unpacker) {
    unpacker.take(w.edge);
    unpacker.take(w.from);
    unpacker.take(w.to);
    const bool backward = unpacker.take() != 0;
    unpacker.take(w.steps);
    w.name_step = static_cast<int8_t>(backward ? -1 : 1);
    w.name_start = backward ? w.steps : 0;
    w.row = {unpacker.take(), w.steps, 2 * w.steps};
    unpacker.take(w.row_step.quotient);
    unpacker.take(w.row_step.remainder);
}

}  // namespace

int sweep_data_width(const Profile& profile) {
    return std::max(profile.sweep_data.width, profile.inverse_w.width);
}

std::vector<Word> SweepLineIn::pack(const Profile& profile) const {
    Packer packer(profile);
    const SweepTriangle& t = triangle;
    packer.add(t.single, t.continues, t.mirror < 0,
               t.corners[t.walks[0].edge.from].slot[t.sweep_axis], t.determinant, t.step_limit);
    for (const SubTriangle& half : t.halves) pack_half(half, packer);
    for (const PrimaryWalk& walk : t.walks) pack_walk(walk.edge, packer);
    for (const SubTriangle& half : t.halves) pack_walk(half.edge, packer);
    for (const SweepCorner& corner : t.corners) packer.add_data(corner.data);
    const auto add_walk = [&](const EdgeWalk& w) {
        packer.add_value(w.start);
        packer.add_value(w.difference);
        packer.add_rest(w.difference);
    };
    for (const PrimaryWalk& walk : t.walks) add_walk(walk.edge);
    for (const SubTriangle& half : t.halves) add_walk(half.edge);
    for (const PrimaryWalk& walk : t.walks) packer.add_value(walk.base);
    for (const SweepVector* difference : {&t.sweep_difference, &t.side_difference}) {
        packer.add_value(*difference);
        packer.add_rest(*difference);
    }
    return packer.take();
}

SweepLineIn SweepLineIn::unpack(const Word* words, const Profile& profile) {
    Unpacker unpacker(words, profile);
    SweepLineIn in;
    SweepTriangle& t = in.triangle;
    t.components = profile.components;
    t.guard_bits = profile.guard_bits;
    unpacker.take(t.single);
    unpacker.take(t.continues);
    t.mirror = static_cast<int8_t>(unpacker.take() != 0 ? -1 : 1);
    const int32_t sweep_start = unpacker.take();
    unpacker.take(t.determinant);
    unpacker.take(t.step_limit);
    for (SubTriangle& half : t.halves) unpack_half(half, unpacker);
    for (PrimaryWalk& walk : t.walks) unpack_walk(walk.edge, unpacker);
    for (SubTriangle& half : t.halves) {
        unpack_walk(half.edge, unpacker);
        half.column_step = {half.columns == half.edge.steps,
                            half.columns == half.edge.steps ? 0 : 2 * half.columns};
    }
    t.corners[t.walks[0].edge.from].slot[0] = sweep_start;
    if (!t.continues) {
        t.corners[t.walks[1].edge.from].slot[0] =
            t.single ? 0 : sweep_start + t.walks[0].edge.steps;
    }
    for (SweepCorner& corner : t.corners) unpacker.take_data(corner.data);
    const auto take_walk = [&](EdgeWalk& w) {
        unpacker.take_start(w.start, w.steps);
        unpacker.take_difference(w.difference, w.steps);
    };
    for (PrimaryWalk& walk : t.walks) take_walk(walk.edge);
    for (SubTriangle& half : t.halves) take_walk(half.edge);
    for (PrimaryWalk& walk : t.walks) unpacker.take_start(walk.base, t.determinant);
    unpacker.take_difference(t.sweep_difference, t.determinant);
    unpacker.take_difference(t.side_difference, t.determinant);
    return in;
}

std::vector<Word> SweepLineOut::pack(const Profile& profile) const {
    Packer packer(profile);
    for (std::size_t k = kSweepStepVertices; k-- > 0;) {
        const bool sent = k < step.vertex_count;
        const SweepVertex vertex = sent ? step.vertices[k] : SweepVertex{};
        packer.add_data(vertex.data);
        packer.add(vertex.name.kind, vertex.name.part, vertex.name.a, vertex.name.b);
    }
    for (std::size_t k = kSweepStepVertices; k-- > 0;) {
        const StripCommand& c = step.strip.commands[k];
        const bool sent = k < step.strip.count;
        packer.add(sent ? static_cast<int>(c.op) << 4 | c.place << 2 | static_cast<int>(c.keep)
                        : 0);
    }
    packer.add(step.strip.count, step.vertex_count, step.strip.init,
               step.strip.init && step.strip.flip, runaway, last);
    return packer.take();
}

}  // namespace repousse
