// The part of the sweep line that moves registers: halves, columns, and the points of the edges.

#include "datapath/units/sweep_line.h"

#include "datapath/numbers/vector_clones.h"

namespace repousse {

// ---- vectors
// -------------------------------------------------------------------------------------

// All loops work on all places, whether the triangle has the components or not: that is faster than
// a loop of variable length.

SweepLine::Vector SweepLine::vector_of(const SweepVector& from) const {
    const int guard = triangle_->guard_bits;
    const int32_t below = (int32_t{1} << guard) - 1;
    Vector to;
    to.modulus = guard == 0 ? from.modulus : below + 1;
    for (std::size_t i = 0; i < kSweepPlaces; ++i) {
        to.value[i] = static_cast<int32_t>(from.value[i] >> guard);
        to.rest[i] = guard == 0 ? from.remainder[i] : static_cast<int32_t>(from.value[i]) & below;
    }
    return to;
}

// `to` may be `a`.
REPOUSSE_VECTOR_CLONES
void SweepLine::sum(const Vector& a, const Vector& d, Vector& to) {
    const int32_t modulus = d.modulus;
    to.modulus = modulus;
    REPOUSSE_INDEPENDENT
    for (std::size_t i = 0; i < kSweepPlaces; ++i) {
        const int32_t rest = a.rest[i] + d.rest[i];
        const int32_t carry = rest >= modulus ? -1 : 0;
        to.rest[i] = rest - (carry & modulus);
        to.value[i] =
            static_cast<int32_t>(static_cast<uint32_t>(a.value[i]) +
                                 static_cast<uint32_t>(d.value[i]) - static_cast<uint32_t>(carry));
    }
}

REPOUSSE_VECTOR_CLONES
void SweepLine::difference(const Vector& a, const Vector& d, Vector& to) {
    const int32_t modulus = d.modulus;
    to.modulus = modulus;
    REPOUSSE_INDEPENDENT
    for (std::size_t i = 0; i < kSweepPlaces; ++i) {
        const int32_t rest = a.rest[i] - d.rest[i];
        const int32_t borrow = rest < 0 ? -1 : 0;
        to.rest[i] = rest + (borrow & modulus);
        to.value[i] =
            static_cast<int32_t>(static_cast<uint32_t>(a.value[i]) -
                                 static_cast<uint32_t>(d.value[i]) + static_cast<uint32_t>(borrow));
    }
}

// ---- registers ----------------------------------------------------------------------------------

// A vertex register that plays no part. There are 8 of them in one lane: of the parts Vstart, both
// Vbases, Vedge, bl, br, tl, tr, the one that is being computed is free. Two lanes keep two more.
SweepLine::Index SweepLine::free_register() {
    unsigned used = 0;
    REPOUSSE_UNROLLED
    for (std::size_t role = 0; role < kRoles; ++role) used |= 1U << roles_[role];
    const auto index = static_cast<Index>(__builtin_ctz(~used >> 4) + 4);
    if (index > counters_.highest_register) counters_.highest_register = index;
    return index;
}

// The one operation on data: a sum with a remainder. The kinds without remainders have zeros.
void SweepLine::add(Role to, Index from, Index which, bool subtract) {
    ++counters_.additions;
    roles_[to] = kInvalid;
    roles_[to] = free_register();
    const Vector &a = registers_[from].vector, &d = registers_[which].vector;
    Vector& result = registers_[roles_[to]].vector;
    if (subtract) {
        difference(a, d, result);
    } else {
        sum(a, d, result);
    }
}

// ---- halves and columns -------------------------------------------------------------------------

void SweepLine::start_walk() {
    walk_ = &triangle_->walks[triangle_->continues ? 0 : half_];
    fresh_walk_ = true;
    edge_sent_ = false;
    start_row_ = walk_->edge.row;
    start_step_ = 0;
    sweep_ = triangle_->corners[walk_->edge.from].slot[triangle_->sweep_axis];
    registers_[Primary].vector = vector_of(walk_->edge.difference);
    roles_[Vstart] = kInvalid;
    roles_[Vstart] = free_register();
    at(Vstart) = {point_of(walk_->edge, 0), vector_of(walk_->edge.start)};
    roles_[Vbase] = kInvalid;
    roles_[Vbase] = free_register();
    at(Vbase).vector = vector_of(walk_->base);
    column_fill_ = kept_left_ = 0;
    spare_is_left_ = spare_is_right_ = false;
    roles_[LastLeft] = roles_[LastRight] = kInvalid;
}

void SweepLine::start_half() {
    const EdgeWalk& edge = half().edge;
    column_ = 0;
    last_ = half().columns == 1;
    registers_[Edge].vector = vector_of(edge.difference);
    roles_[Vedge] = kInvalid;
    roles_[Vedge] = free_register();
    at(Vedge) = {point_of(edge, 0), vector_of(edge.start)};
    edge_step_ = 0;
    edge_valid_ = true;
    edge_row_ = edge.row;
    edge_column_ = {0, edge.steps, 2 * edge.steps};
    // At a tip, the corner is Vstart; beside a half without width, C belongs to the other edge.
    if (half().tip || other_left()) advance_edge();
}

void SweepLine::next_half() {
    if (half_ == 1) {
        triangle_ = nullptr;
        return;
    }
    half_ = 1;
    if (half().columns == 0) {
        triangle_ = nullptr;
        return;
    }
    if (!triangle_->continues) start_walk();
    start_half();
}

void SweepLine::start_column() {
    in_column_ = true;
    first_step_ = true;
    ++counters_.columns;
    steps_in_column_ = 0;
    climbed_ = 0;
    left_moved_ = right_moved_ = false;
    on_edge_ = column_ == 0 && half().tip;
    right_done_ = closes();

    roles_[Bl] = roles_[Vstart];
    left_row_ = start_row_.at;
    roles_[Tl] = roles_[Tr] = roles_[Br] = kInvalid;
    add(Vstart, roles_[Bl], Primary);
    ++start_step_;
    at(Vstart).name = point_of(walk_->edge, start_step_);
    start_row_.advance(walk_->edge.row_step);
    roles_[Br] = roles_[Vstart];
    right_row_ = start_row_.at;
    start_base();

    kept_right_ = 0;
    column_full_ = false;
    if (other_left() || other_right()) {
        // The other edge starts at corner O with a remainder of its own. Its difference goes where
        // nothing is needed any more: Vbase in the first column, Dsweep in the last.
        const Role corner = other_left() ? Bl : Br;
        const Index place = other_left() ? roles_[Vbase] : static_cast<Index>(Sweep);
        const EdgeWalk& edge = other().edge;
        at(corner).vector = vector_of(edge.start);
        registers_[place].vector = vector_of(edge.difference);
        other_row_ = edge.row;
        other_step_ = 0;
    }
}

// next Vbase: the grid point below the next Vstart, one row up or down if that crossed a row.
void SweepLine::start_base() {
    add(NextBase, roles_[Vbase], Sweep, half().direction < 0);
    if (right_row_ == left_row_) return;
    const Index first = roles_[NextBase];
    const bool down = right_row_ < left_row_;
    add(Tl, first, Side, down);  // by way of a free register
    roles_[NextBase] = roles_[Tl];
    roles_[Tl] = kInvalid;
}

void SweepLine::finish_column() {
    in_column_ = false;
    roles_[Vbase] = roles_[NextBase];
    roles_[NextBase] = roles_[Bl] = roles_[Br] = roles_[Tl] = roles_[Tr] = kInvalid;
    roles_[LastLeft] = roles_[LastRight];
    roles_[LastRight] = kInvalid;
    kept_left_ = kept_right_;
    spare_is_left_ = spare_is_right_;
    spare_is_right_ = false;
    sweep_ += half().direction;
    ++column_;
    last_ = column_ + 1 == half().columns;
    if (column_ == half().columns) next_half();
}

// ---- points of the edges ------------------------------------------------------------------------

void SweepLine::advance_edge() {
    const EdgeWalk& edge = half().edge;
    edge_sent_ = false;
    if (edge_step_ == edge.steps) {
        edge_valid_ = false;
        return;
    }
    const Index from = roles_[Vedge];
    add(Vedge, from, Edge);
    ++edge_step_;
    at(Vedge).name = point_of(edge, edge_step_);
    edge_column_.advance(half().column_step);
    edge_row_.advance(edge.row_step);
}

void SweepLine::advance_other() {
    ++other_step_;
    other_row_.advance(other().edge.row_step);
}

}  // namespace repousse
