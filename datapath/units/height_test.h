#pragma once

#include <array>
#include <cstddef>

#include "datapath/error.h"
#include "datapath/items.h"
#include "datapath/profile.h"
#include "datapath/span.h"
#include "datapath/texel_port.h"
#include "datapath/transaction.h"
#include "datapath/units/height_test_desc.h"

namespace repousse {

/// How large the boxes are around the vertices of an edge with U differences du, dv.
enum class BoxKind : uint8_t {
    Square,   ///< e = max(|du|, |dv|) in both directions: never empty on axis-aligned edges
    Literal,  ///< |du| by |dv|, as printed
};

/// What is compared.
enum class HeightMode : uint8_t {
    Average,  ///< |S12/A12 - (S1+S2)/(A1+A2)| > threshold, in height LSB, without a division
    Sum,      ///< |S12/2 - (S1+S2)| > threshold, in height LSB * texel^2, as printed
};

/// The registers of the Summed Height Test.
struct HeightTestRegisters {
    int width = 1;      ///< of the map in texels, 1 to 4096
    int height = 1;     ///< of the map in texels, 1 to 4096
    bool wrap = false;  ///< the map is periodic in both directions
    BoxKind box = BoxKind::Square;
    HeightMode mode = HeightMode::Average;
    uint64_t threshold = 0;

    std::array<Word, 6> pack() const {
        return {width,
                height,
                wrap,
                box == BoxKind::Literal,
                mode == HeightMode::Sum,
                static_cast<Word>(threshold)};
    }
};
static_assert(ports_are(kHeightTestDesc, PortKind::Config,
                        {"map_width", "map_height", "wrap", "literal", "sum", "threshold"}));

/// One edge as it enters the Summed Height Test: the input ports of the description.
struct HeightTestIn {
    bool skip = false;
    Uv u1, u2, u12;

    std::array<Word, 7> pack() const { return {skip, u1.x, u1.y, u2.x, u2.y, u12.x, u12.y}; }
    static HeightTestIn unpack(const Word* w) {
        return {w[0] != 0, uv_from_words(w + 1), uv_from_words(w + 3), uv_from_words(w + 5)};
    }
};
static_assert(ports_are(kHeightTestDesc, PortKind::Input,
                        {"skip", "u1_x", "u1_y", "u2_x", "u2_y", "u12_x", "u12_y"}));

/// What the Summed Height Test says of it.
struct HeightTestOut {
    bool sht = false;

    std::array<Word, 1> pack() const { return {sht}; }
};
static_assert(ports_are(kHeightTestDesc, PortKind::Output, {"sht"}));

/// What the Summed Height Test did beside deciding.
struct HeightTestStats {
    uint64_t reads = 0;    ///< entries of the summed-area table
    uint64_t beats = 0;    ///< requests for them, one a cycle: up to one entry a box
    uint64_t refused = 0;  ///< edges outside the unit's domain; see HeightTest::accepts
};

/// The Summed Height Test (Doggett and Hirche 2000, sections 2.3 and 3.1.3): the heights summed
/// in a box around the new vertex against those in boxes around the two ends, so that a smooth
/// rise that no sampled normal shows still splits the edge.
///
/// The half-extents of the boxes are the edge's extents e >> 2 around U12 and e >> 3 around U1 and
/// U2, so that both sides of the comparison cover the same area. Their corners are floors,
/// lo = (U - half) >> frac and hi = (U + half) >> frac, and the box is [lo, hi). A box sum is four
/// reads of the table of exclusive prefix sums, T(x, y) = sum of h over [0, x) x [0, y), with
/// (W+1) x (H+1) entries stored modulo 2^sat_width, row by row (equation 2).
///
/// Clamped map: corners are clipped to [0, W]. Where only averages are compared, an axis without
/// texels becomes one texel wide. Periodic map: a corner is x = q W + m with q in {-1, 0, 1} by
/// one compare-and-add, and T(x, y) = T(m, y) + q T(W, y), likewise in y. Of the four corners only
/// the difference of the q survives, which is 0 or 1: a box that crosses a seam reads three
/// columns (or rows) instead of two, 6 reads, or 9 at a corner of the map.
///
/// Everything is an integer and symmetric in the two ends: |du| is shifted, never du, and the two
/// ends are added before anything is subtracted.
class HeightTest {
public:
    explicit HeightTest(const Profile& profile);

    /// Says what is wrong with the registers, the size of the table or the profile's widths.
    Status check(const HeightTestRegisters& registers, std::size_t table_entries) const;

    /// Loads the registers and the table, which must outlive the unit's use. Check first.
    void configure(const HeightTestRegisters& registers, Span<const uint64_t> table);

    /// The longest edge, in texels (L-infinity), for which every sum is exact: a box must not hold
    /// more than 2^sat_width - 1, nor span more than one period of a periodic map. It is W for a
    /// W x W map with the 2 log2(W) + height bits - 2 that the table then needs. The parts of an
    /// edge are never longer than the edge, so checking the base mesh is enough.
    int max_edge() const { return max_edge_; }

    /// Whether the unit is defined for an edge: no longer than max_edge() and, on a periodic map,
    /// no vertex further than half a period outside of it.
    bool accepts(Uv u1, Uv u2, Uv u12) const;

    /// The decision. An edge that is not accepted is refused: false, and counted.
    bool operator()(Uv u1, Uv u2, Uv u12, HeightTestStats& stats) const;

    /// One transaction of the unit: a skipped item passes with result 0 and reads nothing.
    HeightTestOut operator()(const HeightTestIn& in, HeightTestStats& stats) const {
        return {!in.skip && (*this)(in.u1, in.u2, in.u12, stats)};
    }

    /// How an edge is read: a function of its data, for the time model.
    struct Reads {
        std::array<int, 3> entries{};  ///< of the table for each box, U1, U2, U12: 4, 6 or 9 each
        int beats = 0;                 ///< requests, one a cycle, that fetch them side by side
    };
    Reads reads(Uv u1, Uv u2, Uv u12) const;

    /// Tests each edge that still needs it (all of them if `eager`) and stores the result. An edge
    /// that the Normal Test has already found needs no second reason to split.
    template <class P>
    void run(Span<Edge<P>> edges, bool eager) {
        counters_.items += edges.size();
        for (Edge<P>& edge : edges) {
            if ((!edge.undecided || edge.nt) && !eager) continue;
            edge.sht = (*this)(edge.v1->uv, edge.v2->uv, edge.mid.uv, stats_);
            ++counters_.tests;
            counters_.positives += edge.sht;
        }
    }

    /// Who is told of every read, in order; null: nobody. It must outlive its use.
    void attach(TexelPort* port) { port_ = port; }

    const TestCounters& counters() const { return counters_; }
    const HeightTestStats& stats() const { return stats_; }
    void reset() { counters_ = {}, stats_ = {}; }

private:
    /// A box along one axis: table coordinates, and how many texels wide it is.
    struct Side {
        int32_t lo = 0;
        int32_t hi = 0;
        int32_t texels = 0;
        bool seam = false;  ///< hi has passed a seam that lo has not: add the table's last column
    };

    /// A box: what equation 2 reads, and its area.
    struct Box {
        Side x, y;
        uint64_t area() const {
            return static_cast<uint64_t>(x.texels) * static_cast<uint64_t>(y.texels);
        }
        int reads() const { return (2 + x.seam) * (2 + y.seam); }
    };

    /// The boxes around U1, U2 and U12.
    struct Boxes {
        Box end1, end2, mid;
        int entries() const { return end1.reads() + end2.reads() + mid.reads(); }
        int beats() const {
            return (2 + (end1.x.seam | end2.x.seam | mid.x.seam)) *
                   (2 + (end1.y.seam | end2.y.seam | mid.y.seam));
        }
    };

    static int32_t reduce(int32_t& x, int32_t size);
    Side side(int32_t centre, int32_t half, int32_t size) const;
    Box box(Uv centre, int32_t half_x, int32_t half_y) const;
    Boxes boxes(Uv u1, Uv u2, Uv u12) const;
    void announce(const Boxes& at) const;
    uint64_t row(int32_t y, const Side& x) const;
    uint64_t sum(const Box& box) const;
    bool differ_in_average(uint64_t mid, uint64_t mid_area, uint64_t ends,
                           uint64_t ends_area) const;
    bool differ_in_sum(uint64_t mid, uint64_t ends) const;

    int frac_;
    int height_bits_;
    int sat_width_;
    uint64_t sat_mask_;
    HeightTestRegisters registers_;
    Span<const uint64_t> table_;
    TexelPort* port_ = nullptr;
    int max_edge_ = 0;
    int32_t max_extent_ = 0;  // max_edge_ in the format of U
    Uv low_, high_;           // where U may lie
    TestCounters counters_;
    HeightTestStats stats_;
};

}  // namespace repousse
