// The sweep line by whole batches. Steps are those of step(), which makes them but where both sides
// climb inside the triangle: there nothing but rows and data change from step to step, and all the
// steps up to the next edge point go at once.

#include <algorithm>
#include <cstring>

#include "datapath/numbers/vector_clones.h"
#include "datapath/units/sweep_line.h"

namespace repousse {

std::size_t SweepLine::fill(Span<SweepRun> runs, SweptVertices<int32_t>& vertices) {
    std::size_t count = 0;
    while (count < runs.size() && vertices.size + out_.vertices.size() <= kFineVertices) {
        SweepRun& run = runs[count];
        if (const uint32_t times = climbing_steps(kFineVertices - vertices.size)) {
            climb(times, run, vertices);
        } else {
            if (!step(out_)) break;
            run = {out_.strip, out_.vertex_count, 1};
            for (std::size_t i = 0; i < out_.vertex_count; ++i) {
                vertices.push_back(out_.vertices[i].name, out_.vertices[i].data);
            }
        }
        ++count;
    }
    return count;
}

// How many of the next steps take the left vertex from the column FIFO, make the right one and keep
// it, as the step before did. At most `most`.
uint32_t SweepLine::climbing_steps(std::size_t most) const {
    const bool climbs = triangle_ != nullptr && in_column_ && !right_done_ && !on_edge_ &&
                        left_row_ == right_row_ && left_is_older_ && roles_[Bl] == kInvalid &&
                        roles_[Br] != kInvalid && roles_[Br] == roles_[LastRight] && !column_full_;
    if (!climbs) return 0;
    const auto limit = static_cast<int32_t>(triangle_->step_limit - steps_in_column_);
    int32_t steps = std::min({static_cast<int32_t>(most), kept_left_, limit});
    if (edge_in(column_) || edge_in(column_ + 1)) {
        steps = std::min(steps, edge_row_.at - left_row_ - 1);
    }
    return static_cast<uint32_t>(steps > 0 ? steps : 0);
}

void SweepLine::climb(uint32_t times, SweepRun& run, SweptVertices<int32_t>& vertices) {
    run.strip.init = false;
    run.strip.count = 2;
    run.strip.commands[0] = {StripOp::Column, left_place_, StripKeep::No};
    run.strip.commands[1] = {StripOp::New, spare_place_, StripKeep::Column};
    run.vertex_count = 1;
    run.times = times;

    Vector vector = at(Br).vector;
    advance(vector, registers_[Side].vector, triangle_->guard_bits, times, vertices);
    for (uint32_t i = 0; i < times; ++i) {
        vertices.names[vertices.size++] = inside(sweep_ + half().direction, ++right_row_);
    }
    // A sum never replaces its operand: two registers take turns.
    for (uint32_t i = 0; i < std::min(times, 2 + times % 2); ++i) {
        roles_[Br] = roles_[LastRight] = free_register();
    }
    at(Br) = {vertices.names[vertices.size - 1], vector};

    left_row_ = right_row_;
    spare_row_ = right_row_;
    spare_is_left_ = false;
    spare_is_right_ = true;
    right_place_ = spare_place_;
    steps_in_column_ += times;
    kept_left_ -= static_cast<int32_t>(times);
    kept_right_ += static_cast<int32_t>(times);
    count(times);
}

// What single steps would have counted.
void SweepLine::count(uint32_t climbs) {
    counters_.steps += climbs;
    counters_.quads += climbs;
    counters_.triangles += 2 * uint64_t{climbs};
    counters_.additions += climbs;
    counters_.commands += 2 * uint64_t{climbs};
    counters_.vertices += 2 * uint64_t{climbs};
    counters_.displaced += climbs;
    counters_.kept += climbs;
}

namespace {

/// Eight places of a vector, in a vector register where the processor has one of that size. Values
/// wrap, remainders do not.
using Values = uint32_t __attribute__((vector_size(32)));
using Rests = int32_t __attribute__((vector_size(32)));
constexpr std::size_t kLanes = sizeof(Values) / sizeof(uint32_t);

/// Sums as sum() makes them, one after the other.
struct LaneSums {
    Values value, step;
    Rests rest, step_rest;

    void next(const Rests& modulus) {
        rest += step_rest;
        const Rests carry = rest >= modulus;  // -1 or 0
        rest -= carry & modulus;
        value += step - reinterpret_cast<Values>(carry);
    }
    void round(int half_bit, int32_t* to) const {
        const Values rounded = value + reinterpret_cast<Values>(rest >> half_bit);
        std::memcpy(to, &rounded, sizeof(Values));
    }
};

}  // namespace

// In blocks, which stay in the first-level cache between the sums and their columns.
REPOUSSE_VECTOR_CLONES
void SweepLine::advance(Vector& at, const Vector& step, int guard_bits, uint32_t times,
                        SweptVertices<int32_t>& to) {
    constexpr uint32_t kBlock = 16;
    constexpr std::size_t kSums = kSweepPlaces / kLanes;
    const Rests modulus = Rests{} + step.modulus;
    const int half = half_bit(guard_bits);
    LaneSums sums[kSums];
    for (std::size_t j = 0; j < kSums; ++j) {
        std::memcpy(&sums[j].value, &at.value[kLanes * j], sizeof(Values));
        std::memcpy(&sums[j].rest, &at.rest[kLanes * j], sizeof(Values));
        std::memcpy(&sums[j].step, &step.value[kLanes * j], sizeof(Values));
        std::memcpy(&sums[j].step_rest, &step.rest[kLanes * j], sizeof(Values));
    }
    alignas(Values) int32_t rows[kBlock][kSweepPlaces];
    for (uint32_t first = 0; first < times; first += kBlock) {
        const uint32_t n = std::min(kBlock, times - first);
        for (uint32_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < kSums; ++j) {
                sums[j].next(modulus);
                sums[j].round(half, &rows[i][kLanes * j]);
            }
        }
        for (std::size_t k = 0; k < kSweepComponents; ++k) {
            int32_t* column = to.data[k].data() + to.size + first;
            for (uint32_t i = 0; i < n; ++i) column[i] = rows[i][k];
        }
    }
    at.modulus = step.modulus;
    for (std::size_t j = 0; j < kSums; ++j) {
        std::memcpy(&at.value[kLanes * j], &sums[j].value, sizeof(Values));
        std::memcpy(&at.rest[kLanes * j], &sums[j].rest, sizeof(Values));
    }
}

}  // namespace repousse
