#pragma once

#include <array>

#include "datapath/items.h"
#include "datapath/profile.h"
#include "datapath/span.h"
#include "datapath/transaction.h"
#include "datapath/units/texcoord_test_desc.h"

namespace repousse {

/// One edge as it enters the Tex Coord Test: the input ports of the description.
struct TexcoordTestIn {
    bool skip = false;
    Uv u1, u2, u12;

    std::array<Word, 7> pack() const { return {skip, u1.x, u1.y, u2.x, u2.y, u12.x, u12.y}; }
    static TexcoordTestIn unpack(const Word* w) {
        return {w[0] != 0, uv_from_words(w + 1), uv_from_words(w + 3), uv_from_words(w + 5)};
    }
};
static_assert(ports_are(kTexcoordTestDesc, PortKind::Input,
                        {"skip", "u1_x", "u1_y", "u2_x", "u2_y", "u12_x", "u12_y"}));

/// What the Tex Coord Test says of it.
struct TexcoordTestOut {
    bool ct = false;

    std::array<Word, 1> pack() const { return {ct}; }
};
static_assert(ports_are(kTexcoordTestDesc, PortKind::Output, {"ct"}));

/// The Tex Coord Test (Doggett and Hirche 2000, section 2.5): refinement stops where the map has
/// no more detail. An edge may be split only if the new vertex U12 lies in another texel than
/// both ends:
///
///     ct = not (floor(U12) = floor(U1) or floor(U12) = floor(U2)),   both components at once.
///
/// The coordinates are neither clamped nor wrapped before: at a seam that is what makes both sides
/// agree. The decision is symmetric in the two ends, and false for a degenerate edge (U1 = U2).
class TexcoordTest {
public:
    explicit TexcoordTest(const Profile& profile);

    /// Texel coordinates in the profile's `uv`; U12 = (U1 + U2) >> 1 in the pipeline, but any
    /// value is accepted.
    bool operator()(Uv u1, Uv u2, Uv u12) const {
        return !same_texel(u12, u1) && !same_texel(u12, u2);
    }

    /// One transaction of the unit: a skipped item passes with result 0.
    TexcoordTestOut operator()(const TexcoordTestIn& in) const {
        return {!in.skip && (*this)(in.u1, in.u2, in.u12)};
    }

    /// Tests each edge that is not yet decided (all of them if `eager`) and stores the result.
    template <class P>
    void run(Span<Edge<P>> edges, bool eager) {
        counters_.items += edges.size();
        for (Edge<P>& edge : edges) {
            if (!edge.undecided && !eager) continue;
            edge.ct = (*this)(edge.v1->uv, edge.v2->uv, edge.mid.uv);
            edge.undecided &= edge.ct;
            ++counters_.tests;
            counters_.positives += edge.ct;
        }
    }

    const TestCounters& counters() const { return counters_; }
    void reset() { counters_ = {}; }

private:
    /// Equal after the fraction is dropped. The arithmetic shift is a floor, so the texel left of
    /// the map is -1 and not 0 again.
    bool same_texel(Uv a, Uv b) const {
        return a.x >> frac_ == b.x >> frac_ && a.y >> frac_ == b.y >> frac_;
    }

    int frac_;
    TestCounters counters_;
};

}  // namespace repousse
