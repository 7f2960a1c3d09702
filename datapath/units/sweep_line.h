#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "datapath/fine_vertices.h"
#include "datapath/span.h"
#include "datapath/sweep_items.h"
#include "datapath/units/sweep_line_desc.h"

namespace repousse {

/// The repairs that make the paper's remesher cover every triangle exactly once. The device has
/// them all; a study switches single ones off to show what breaks.
struct SweepRepairs {
    bool climb = true;        ///< R1: the left side climbs all edge points of its column
    bool drag_below = true;   ///< R2: drag onto the edge at or below the candidate row, not only at
    bool last_column = true;  ///< R3: only the far end of the edge lies in the last column
    bool many_points = true;  ///< R4: more than one further edge point in a column
    bool other_edge = true;   ///< R5: beside a half without width, that half's edge is walked
    bool single = true;       ///< R6: a triangle on one grid point is passed on whole
    bool right_stall = true;  ///< R7: the right side waits while the edge point is the left's
    bool closing_fan = true;  ///< R8: ears to several edge points in the last strip before a tip
};

/// How the unit is built.
struct SweepLineOptions {
    int column_depth = 0;  ///< vertices the column FIFO, and the split FIFO, hold; 0: one lane
    SweepRepairs repairs;
};

/// What `sweep_line` counted.
struct SweepLineCounters {
    uint64_t items = 0;             ///< base triangles
    uint64_t columns = 0;           ///< strips
    uint64_t steps = 0;             ///< of the side walk
    uint64_t quads = 0;             ///< steps that moved both sides
    uint64_t ears = 0;              ///< triangles of repair R8
    uint64_t triangles = 0;         ///< fine triangles
    uint64_t additions = 0;         ///< vector additions
    uint64_t commands = 0;          ///< for the stripping unit, init included
    uint64_t swaps = 0;             ///< of these, refs that only turn the strip
    uint64_t vertices = 0;          ///< vertices put into a strip register
    uint64_t displaced = 0;         ///< of these, new ones: each is displaced and lit once
    uint64_t kept = 0;              ///< vertices kept for the next column or half
    uint64_t highest_register = 0;  ///< ever used: 11 in one lane, below 15 in two
    uint64_t runaways = 0;          ///< triangles given up by the guard
};

/// One step of the sweep line: commands, and the vertices of the `New` ones in their order.
struct SweepStep {
    StripStep strip;
    uint8_t vertex_count = 0;
    std::array<SweepVertex, 4> vertices;
};

/// Sub-triangle remeshing (Gumhold and Huettner 3.4.4) as a register machine that only adds and
/// compares.
///
///  1. A half starts with Vstart at an end of the primary edge, Vbase on the grid point below it,
///     and Vedge on the edge.
///  2. A column starts a strip: bl = Vstart, Vstart += Dprimary, br = Vstart, and
///     next Vbase = Vbase +- Dsweep +- Dside.
///  3. The side walk moves the lower side up, both if they are level: onto the edge if its next
///     point is in this column and not above, else by Dside.
///  4. Each step goes out as up to four commands, with the new vertices.
///
/// Vertices are assigned by copying a four-bit index. Control sees slots alone, which advance
/// exactly whatever the kind of adder is: the triangles are the same for all kinds, and only the
/// data of vertices differ.
///
/// With a column FIFO, the vertices inside a right column are kept in the stripping unit, and the
/// next left column, which consists of just these and edge points, takes them from there. A roof's
/// split column is kept too, for the second half. What does not fit is sent again.
class SweepLine {
public:
    explicit SweepLine(const SweepLineOptions& options = {}) : options_(options) {}

    /// Takes a base triangle, which must outlive its remeshing; the unit must be idle.
    void load(const SweepTriangle& triangle);

    /// One step. False if there was none: the triangle is finished.
    bool step(SweepStep& out);

    /// The next steps, as long as there are free runs and room for the vertices of any step. How
    /// many runs: 0 if there was no step, as the triangle is finished.
    std::size_t fill(Span<SweepRun> runs, SweptVertices<int32_t>& vertices);

    /// load() and every step, to `sink(const SweepStep&)`.
    template <class Sink>
    void run(const SweepTriangle& triangle, Sink&& sink) {
        load(triangle);
        while (step(out_)) sink(static_cast<const SweepStep&>(out_));
    }

    /// Drops the triangle in the unit. The stripping unit must be flushed before the next one: its
    /// FIFOs may hold vertices of this one.
    void abort() { triangle_ = nullptr; }

    bool busy() const { return triangle_ != nullptr; }
    bool runaway() const { return runaway_; }  ///< status bit, sticky until reset
    const SweepLineOptions& options() const { return options_; }
    const SweepLineCounters& counters() const { return counters_; }

    /// The state after power-on.
    void reset();

private:
    using Index = uint8_t;
    static constexpr Index kInvalid = 15;
    enum Difference : Index { Primary, Edge, Sweep, Side };
    // Which register plays which part.
    enum Role { Vstart, NextBase, Vbase, Vedge, Bl, Br, Tl, Tr, LastLeft, LastRight, kRoles };
    enum class Ear : uint8_t { None, Pending, Fan };
    // What a side steps onto.
    enum class Move : uint8_t { Stay, Inside, OnEdge, OnOther };

    /// A vector as the adders of the unit hold it: the value's LSB and above, and what lies below
    /// them, guard bits or a remainder, in units of 1/modulus. Both sums are one kind of addition
    /// then, and 32 bits are enough: values count modulo 2^32, more than a component has.
    struct Vector {
        alignas(32) std::array<int32_t, kSweepPlaces> value{};
        alignas(32) std::array<int32_t, kSweepPlaces> rest{};  ///< 0 .. modulus - 1
        int32_t modulus = 1;
    };

    struct Register {
        VertexName name;
        Vector vector;
    };

    const SubTriangle& half() const { return triangle_->halves[half_]; }
    const SubTriangle& other() const { return triangle_->halves[1 - half_]; }
    Register& at(Role role) { return registers_[roles_[role]]; }
    bool other_left() const {
        return options_.repairs.other_edge && half().other_left && column_ == 0;
    }
    bool other_right() const { return options_.repairs.other_edge && half().other_right && last_; }
    bool closes() const { return last_ && half().closing; }

    /// A vector of the setup.
    Vector vector_of(const SweepVector& from) const;
    /// How far the bit of half an LSB is above the lowest one of `rest`; without guard bits, whose
    /// vectors are rounded already, so far that there is none.
    static int half_bit(int guard_bits) { return guard_bits == 0 ? 31 : guard_bits - 1; }
    static void sum(const Vector& a, const Vector& d, Vector& to);
    static void difference(const Vector& a, const Vector& d, Vector& to);

    Index free_register();
    void add(Role to, Index from, Index which, bool subtract = false);
    VertexName inside(int32_t sweep, int32_t row) const {
        return {NameKind::Interior, 0, static_cast<int16_t>(sweep),
                static_cast<int16_t>(triangle_->mirror * row)};
    }

    void start_walk();
    void start_half();
    void start_column();
    void start_base();
    void finish_column();
    void next_half();

    int32_t edge_column() const;
    bool edge_in(int32_t column) const { return edge_valid_ && edge_column() == column; }
    bool edge_reached(int32_t row) const;
    bool can_go_left() const;
    void advance_edge();
    void advance_other();

    void walk(SweepStep& out);
    Move move_left();
    Move move_right();
    void send_left(SweepStep& out, Move move);
    void send_right(SweepStep& out, Move move);
    void start_strip(SweepStep& out, bool right_first);
    void send_single(SweepStep& out);
    void start_ears(SweepStep& out);
    void send_ear(SweepStep& out);
    bool split_column_again() const;
    StripKeep keep(bool whole_column);

    uint32_t climbing_steps(std::size_t most) const;
    void climb(uint32_t times, SweepRun& run, SweptVertices<int32_t>& vertices);
    void count(uint32_t climbs);
    static void advance(Vector& at, const Vector& step, int guard_bits, uint32_t times,
                        SweptVertices<int32_t>& to);

    void init(SweepStep& out, bool flip);
    void command(SweepStep& out, StripOp op, uint8_t place, StripKeep kept = StripKeep::No);
    void send(SweepStep& out, Index source, uint8_t place, StripKeep kept = StripKeep::No);

    SweepLineOptions options_;
    SweepLineCounters counters_;
    SweepStep out_;
    std::array<Register, kSweepTwoLaneRegisters + 1> registers_;

    const SweepTriangle* triangle_ = nullptr;
    const PrimaryWalk* walk_ = nullptr;
    std::size_t half_ = 0;

    // Slots: rows of Vstart, Vedge and the other side edge, and the column of Vedge.
    SlotWalk start_row_, edge_row_, edge_column_, other_row_;
    int32_t left_row_ = 0, right_row_ = 0, top_left_row_ = 0, top_right_row_ = 0;
    int32_t sweep_ = 0;       // sweep coordinate of the left column
    int32_t column_ = 0;      // its number within the half
    int32_t start_step_ = 0;  // of Vstart on the primary edge, from where the walk started
    int32_t edge_step_ = 0;
    int32_t other_step_ = 0;
    uint32_t steps_in_column_ = 0;

    // Fill of the FIFOs in the stripping unit.
    int32_t column_fill_ = 0;  // vertices in the column FIFO
    int32_t kept_left_ = 0;    // of these, vertices of the left column
    int32_t kept_right_ = 0;
    int32_t split_fill_ = 0;
    int32_t spare_row_ = 0;  // of the vertex in the spare strip register

    std::array<Index, kRoles> roles_{};
    bool runaway_ = false;
    bool fresh_walk_ = true;  // Vstart is a corner that no strip register holds
    bool last_ = false;       // the strip is the half's last one
    bool edge_valid_ = false;
    bool edge_sent_ = false;  // the strip's edge register holds Vedge
    bool top_sent_ = false;   // and here, tl, which was Vedge
    bool in_column_ = false;
    bool first_step_ = false;
    bool left_moved_ = false, right_moved_ = false;
    bool on_edge_ = false;  // the left side has reached the edge
    bool right_done_ = false;
    bool column_full_ = false;  // the rest of this right column is not kept
    bool split_full_ = false;
    uint8_t climbed_ = 0;  // edge points taken in this column, counted for R4 up to 3
    Ear ear_ = Ear::None;

    // Strip registers by part. The spare one holds the highest inside vertex of the left column, or
    // of the right one: where the column has no other, the left side finds it there.
    uint8_t left_place_ = 0, spare_place_ = 1, start_place_ = 2, edge_place_ = 3, right_place_ = 2;
    bool spare_is_left_ = false, spare_is_right_ = false;
    bool left_is_older_ = true;  // of the strip's last two vertices
};

}  // namespace repousse
