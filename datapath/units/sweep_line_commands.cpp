// The side of the sweep line that faces the stripping unit: what a step sends, and which strip
// register it uses.

#include <cstddef>

#include "datapath/units/sweep_line.h"

namespace repousse {

void SweepLine::init(SweepStep& out, bool flip) {
    out.strip.init = true;
    out.strip.flip = flip;
    ++counters_.commands;
}

void SweepLine::command(SweepStep& out, StripOp op, uint8_t place, StripKeep kept) {
    out.strip.commands[out.strip.count++] = {op, place, kept};
    ++counters_.commands;
    counters_.vertices += op != StripOp::Ref;
    counters_.kept += kept != StripKeep::No;
}

// A new vertex: corners as they came, all others rounded half up to the LSB of the data.
void SweepLine::send(SweepStep& out, Index source, uint8_t place, StripKeep kept) {
    command(out, StripOp::New, place, kept);
    ++counters_.displaced;
    SweepVertex& vertex = out.vertices[out.vertex_count++];
    const Register& from = registers_[source];
    vertex.name = from.name;
    if (from.name.kind == NameKind::Corner) {
        vertex.data = triangle_->corners[from.name.part].data;
        return;
    }
    const Vector& v = from.vector;
    const int half = half_bit(triangle_->guard_bits);
    for (std::size_t i = 0; i < kSweepComponents; ++i) {
        vertex.data[i] = static_cast<int32_t>(static_cast<uint32_t>(v.value[i]) +
                                              static_cast<uint32_t>(v.rest[i] >> half));
    }
}

void SweepLine::send_single(SweepStep& out) {
    init(out, false);
    for (uint8_t corner = 0; corner < 3; ++corner) {
        registers_[4].name = {NameKind::Corner, corner, 0, 0};
        send(out, 4, corner);
    }
    ++counters_.triangles;
}

// Whether this right column is a roof's split column, which the first half has sent already.
bool SweepLine::split_column_again() const {
    return !triangle_->continues && half_ == 1 && last_ && split_fill_ > 0;
}

// Where a vertex of the right column is kept as it is sent. Kept vertices are the lowest of their
// column without a gap, since a FIFO returns them in order.
StripKeep SweepLine::keep(bool whole_column) {
    if (options_.column_depth == 0) return StripKeep::No;
    const bool another = half_ == 0 && triangle_->halves[1].columns > 0;
    if (last_ && !triangle_->continues) {
        if (!another || split_full_) return StripKeep::No;
        split_full_ = ++split_fill_ == options_.column_depth;
        return StripKeep::Split;
    }
    if (whole_column || (last_ && !another) || column_full_) return StripKeep::No;
    if (column_fill_ == options_.column_depth) {
        column_full_ = true;
        return StripKeep::No;
    }
    ++column_fill_;
    ++kept_right_;
    return StripKeep::Column;
}

// bl, then br; the other way round if the right side moves first, so that no swap is needed.
void SweepLine::start_strip(SweepStep& out, bool right_first) {
    const uint8_t freed = left_place_;
    left_place_ = start_place_;
    start_place_ = freed;
    right_place_ = start_place_;
    init(out, half().flip != right_first);
    left_is_older_ = !right_first;
    for (int i = 0; i < 2; ++i) {
        if ((i == 0) == right_first) {
            if (split_column_again()) {
                --split_fill_;
                command(out, StripOp::Split, right_place_);
            } else {
                send(out, roles_[Br], right_place_, keep(true));
            }
        } else if (fresh_walk_) {
            send(out, roles_[Bl], left_place_);
        } else {
            command(out, StripOp::Ref, left_place_);
        }
    }
    fresh_walk_ = false;
}

void SweepLine::send_left(SweepStep& out, Move move) {
    if (!left_is_older_) {
        command(out, StripOp::Ref, right_place_);
        ++counters_.swaps;
    }
    left_is_older_ = false;
    const bool in_spare =
        move == Move::Inside && spare_is_left_ && spare_row_ == top_left_row_ && kept_left_ == 0;
    if (in_spare || (move == Move::OnEdge && top_sent_)) {
        uint8_t& holder = in_spare ? spare_place_ : edge_place_;
        const uint8_t freed = left_place_;
        left_place_ = holder;
        holder = freed;
        spare_is_left_ = false;
        command(out, StripOp::Ref, left_place_);
    } else if (move == Move::Inside && kept_left_ > 0) {
        --kept_left_;
        --column_fill_;
        command(out, StripOp::Column, left_place_);
    } else {
        send(out, roles_[Tl], left_place_);
    }
}

void SweepLine::send_right(SweepStep& out, Move move) {
    if (left_is_older_) {
        command(out, StripOp::Ref, left_place_);
        ++counters_.swaps;
    }
    left_is_older_ = true;
    right_place_ = move == Move::OnEdge ? edge_place_ : spare_place_;
    if (move == Move::OnEdge) {
        edge_sent_ = true;
    } else {
        spare_is_left_ = false;
        spare_is_right_ = move == Move::Inside;
        spare_row_ = top_right_row_;
    }
    if (move != Move::OnOther && split_column_again()) {
        --split_fill_;
        command(out, StripOp::Split, right_place_);
        return;
    }
    const StripKeep kept = move == Move::OnOther ? StripKeep::No : keep(move == Move::OnEdge);
    if (kept == StripKeep::Column) roles_[LastRight] = roles_[Tr];
    send(out, roles_[Tr], right_place_, kept);
}

// ---- ears (R8) ----------------------------------------------------------------------------------

// Edge points e0, e1 .. en lie in the last strip before a tip: a fan (bl, e1, e0) .. around bl,
// then (bl, br, en). As a strip: e0 bl e1, and bl again before each further one. e0 is in Tl.
void SweepLine::start_ears(SweepStep& out) {
    ear_ = Ear::Pending;
    if (out.strip.count == 0) send_ear(out);
}

void SweepLine::send_ear(SweepStep& out) {
    const auto take_edge_point = [&] {
        const uint8_t place = spare_place_;
        spare_place_ = edge_place_;
        edge_place_ = place;
        roles_[Tl] = roles_[Vedge];
        send(out, roles_[Vedge], place);
        advance_edge();
        ++counters_.ears;
        ++counters_.triangles;
    };
    if (ear_ == Ear::Pending) {
        ear_ = Ear::Fan;
        init(out, half().flip);
        if (top_sent_) {
            command(out, StripOp::Ref, edge_place_);
        } else {
            send(out, roles_[Tl], edge_place_);
        }
        command(out, StripOp::Ref, left_place_);
        take_edge_point();
        return;
    }
    command(out, StripOp::Ref, left_place_);
    ++counters_.swaps;
    if (edge_in(column_)) {
        take_edge_point();
        return;
    }
    command(out, StripOp::Ref, right_place_);
    ++counters_.triangles;
    ear_ = Ear::None;
    finish_column();
}

}  // namespace repousse
