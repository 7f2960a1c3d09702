#include "datapath/units/sweep_line.h"

namespace repousse {

void SweepLine::reset() {
    abort();
    counters_ = {};
    runaway_ = false;
}

void SweepLine::load(const SweepTriangle& triangle) {
    triangle_ = &triangle;
    ++counters_.items;
    half_ = 0;
    fresh_walk_ = true;
    in_column_ = false;
    ear_ = Ear::None;
    split_fill_ = 0;
    split_full_ = false;
    roles_.fill(kInvalid);
    // The same commands for the same triangle, whatever went before.
    left_place_ = 0;
    spare_place_ = 1;
    start_place_ = 2;
    edge_place_ = 3;
    if (triangle.single) return;
    registers_[Sweep].vector = vector_of(triangle.sweep_difference);
    registers_[Side].vector = vector_of(triangle.side_difference);
    start_walk();
    if (half().columns == 0) {
        next_half();
    } else {
        start_half();
    }
}

bool SweepLine::step(SweepStep& out) {
    out.strip.init = false;
    out.strip.count = 0;
    out.vertex_count = 0;
    if (triangle_ == nullptr) return false;
    if (triangle_->single) {
        if (options_.repairs.single) send_single(out);
        triangle_ = nullptr;
        return out.strip.count != 0;
    }
    if (ear_ != Ear::None) {
        send_ear(out);
        return true;
    }
    if (!in_column_) start_column();
    if (++steps_in_column_ > triangle_->step_limit) {
        runaway_ = true;
        ++counters_.runaways;
        triangle_ = nullptr;
        return false;
    }
    walk(out);
    return true;
}

// ---- the edge -----------------------------------------------------------------------------------

// R3: every point but the far end stays out of the last column.
int32_t SweepLine::edge_column() const {
    if (edge_step_ == half().edge.steps) return half().columns;
    if (options_.repairs.last_column && edge_column_.at >= half().columns) {
        return half().columns - 1;
    }
    return edge_column_.at;
}

// R2: the edge point is dragged to although the candidate is above it already.
bool SweepLine::edge_reached(int32_t row) const {
    return options_.repairs.drag_below ? edge_row_.at <= row : edge_row_.at == row;
}

// R1 and R4: on the edge, the left side goes on while points are left in its column.
bool SweepLine::can_go_left() const {
    if (!on_edge_) return true;
    if (!options_.repairs.climb || !edge_in(column_)) return false;
    return options_.repairs.many_points || climbed_ < 2;
}

// ---- the side walk ------------------------------------------------------------------------------

void SweepLine::walk(SweepStep& out) {
    const bool edge_left = edge_in(column_);
    const bool can_left = can_go_left();
    const bool can_right = !right_done_;
    bool go_left = can_left && !(can_right && left_row_ > right_row_);
    bool go_right = can_right && !(can_left && right_row_ > left_row_);
    const bool stall = options_.repairs.right_stall;
    // R7: the next edge point belongs to the left column, so the left side goes first.
    if (stall && go_right && !go_left && can_left && edge_left && edge_row_.at <= right_row_ + 1) {
        go_right = false;
        go_left = true;
    }
    ++counters_.steps;
    if (first_step_) start_strip(out, !go_left);
    first_step_ = false;

    Move left = Move::Stay, right = Move::Stay;
    if (go_left) {
        left = move_left();
        // R8: more points of the edge before the tip.
        if (left == Move::OnEdge && options_.repairs.closing_fan && closes() && edge_in(column_)) {
            start_ears(out);
            return;
        }
    }
    // R7 once more, for the point that is next now.
    if (go_left && stall && edge_in(column_) && edge_row_.at <= right_row_ + 1) go_right = false;
    if (go_right) right = move_right();

    if (go_left) send_left(out, left);
    if (go_right) send_right(out, right);
    counters_.quads += go_left && go_right;
    counters_.triangles += static_cast<uint64_t>(go_left + go_right);
    if (go_left) {
        roles_[Bl] = roles_[Tl];
        roles_[Tl] = kInvalid;
        left_row_ = top_left_row_;
        left_moved_ = true;
    }
    if (go_right) {
        roles_[Br] = roles_[Tr];
        roles_[Tr] = kInvalid;
        right_row_ = top_right_row_;
        right_moved_ = true;
    }
    if (!can_go_left() && right_done_) finish_column();
}

SweepLine::Move SweepLine::move_left() {
    if (other_left() && !on_edge_) {
        add(Tl, roles_[Bl], roles_[Vbase]);
        advance_other();
        at(Tl).name = point_of(other().edge, other_step_);
        top_left_row_ = other_row_.at;
        on_edge_ = other_step_ == other().edge.steps;
        return Move::OnOther;
    }
    if (on_edge_ || (edge_in(column_) && edge_reached(left_row_ + 1))) {
        roles_[Tl] = roles_[Vedge];
        top_left_row_ = edge_row_.at;
        climbed_ = static_cast<uint8_t>(climbed_ < 3 ? climbed_ + 1 : 3);
        on_edge_ = true;
        top_sent_ = edge_sent_;
        advance_edge();
        return Move::OnEdge;
    }
    top_left_row_ = left_row_ + 1;
    if (kept_left_ > 0) {  // the column FIFO has it: no data here
        roles_[Tl] = kInvalid;
        return Move::Inside;
    }
    // The last vertex that the FIFO held, where this column is taller than it.
    const bool after_fifo = left_moved_ && roles_[Bl] == kInvalid;
    const Index from = after_fifo ? roles_[LastLeft] : left_moved_ ? roles_[Bl] : roles_[Vbase];
    add(Tl, from, Side);
    at(Tl).name = inside(sweep_, top_left_row_);
    return Move::Inside;
}

SweepLine::Move SweepLine::move_right() {
    if (other_right()) {
        add(Tr, roles_[Br], Sweep);
        advance_other();
        at(Tr).name = point_of(other().edge, other_step_);
        top_right_row_ = other_row_.at;
        right_done_ = other_step_ == other().edge.steps;
        return Move::OnOther;
    }
    if (edge_in(column_ + 1) && edge_reached(right_row_ + 1)) {
        roles_[Tr] = roles_[Vedge];  // which stays: it is the next left column's too
        top_right_row_ = edge_row_.at;
        right_done_ = true;
        return Move::OnEdge;
    }
    top_right_row_ = right_row_ + 1;
    add(Tr, right_moved_ ? roles_[Br] : roles_[NextBase], Side);
    at(Tr).name = inside(sweep_ + half().direction, top_right_row_);
    return Move::Inside;
}

}  // namespace repousse
