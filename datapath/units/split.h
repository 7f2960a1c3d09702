#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "datapath/items.h"
#include "datapath/numbers/policy.h"
#include "datapath/profile.h"
#include "datapath/span.h"
#include "datapath/transaction.h"
#include "datapath/units/split_desc.h"

namespace repousse {

/// A triangle as it enters Pass or Tessellate: the input ports of the description.
struct SplitIn {
    uint8_t eligible = 0;  ///< bit e: edge e may be split; the tests' results likewise
    uint8_t ct = 0, vt = 0, nt = 0, sht = 0;
    std::array<Vec3<int32_t>, 6> displaced;  ///< P' of the corners, and of the edges' new vertices

    std::array<Word, 23> pack() const {
        std::array<Word, 23> words{eligible, ct, vt, nt, sht};
        std::size_t at = 5;
        for (const Vec3<int32_t>& p : displaced) {
            words[at++] = p.x, words[at++] = p.y, words[at++] = p.z;
        }
        return words;
    }
    static SplitIn unpack(const Word* w) {
        SplitIn in;
        for (uint8_t* bits : {&in.eligible, &in.ct, &in.vt, &in.nt, &in.sht}) {
            *bits = static_cast<uint8_t>(*w++);
        }
        for (Vec3<int32_t>& p : in.displaced) {
            for (int32_t* c : {&p.x, &p.y, &p.z}) *c = static_cast<int32_t>(*w++);
        }
        return in;
    }
};
static_assert(ports_are(kSplitDesc, PortKind::Input,
                        {"eligible",  "ct",        "vt",        "nt",        "sht",
                         "corner1_x", "corner1_y", "corner1_z", "corner2_x", "corner2_y",
                         "corner2_z", "corner3_x", "corner3_y", "corner3_z", "mid12_x",
                         "mid12_y",   "mid12_z",   "mid23_x",   "mid23_y",   "mid23_z",
                         "mid31_x",   "mid31_y",   "mid31_z"}));
static_assert(ports_are(kSplitDesc, PortKind::Config, {"has_surface_test"}));

/// One child of it, or the triangle itself.
struct SplitOut {
    uint8_t digit = 0;
    std::array<uint8_t, 3> vertices{0, 1, 2};  ///< which of SplitIn::displaced
    uint8_t unsplit = 0;
    bool pass = false;
    bool last = false;

    std::array<Word, 7> pack() const {
        return {digit, vertices[0], vertices[1], vertices[2], unsplit, pass, last};
    }
};
static_assert(ports_are(kSplitDesc, PortKind::Output,
                        {"digit", "vertex1", "vertex2", "vertex3", "unsplit", "pass", "last"}));

/// The beats that a triangle leaves as.
struct SplitBeats {
    std::array<SplitOut, 4> beats;
    int count = 0;
};

/// The triangles that one triangle turns into, in push order. None: it passes.
template <class P>
struct Children {
    std::array<Child<P>, 4> triangles;
    int count = 0;
};

/// What `split` counted.
struct SplitCounters {
    uint64_t items = 0;                     ///< triangles
    std::array<uint64_t, 4> edges_split{};  ///< triangles by number of split edges
    uint64_t overflows = 0;                 ///< a diagonal's component left its format
};

/// Pass or Tessellate and Tessellation (Doggett and Hirche 2.6, 3.1.5, figure 6).
///
///  1. split = (nt | sht) & vt & ct, for eligible edges; without any surface test in the scene
///     every edge counts as detailed;
///  2. a triangle without a split edge passes;
///  3. one split edge: two triangles; three: four triangles; two: the corner triangle and a quad,
///     cut along the diagonal that is shorter after displacement. The diagonal is interior to the
///     triangle, so its choice can round without ever opening an edge.
template <class P>
class Split {
public:
    using V = typename P::Value;

    explicit Split(const Profile& profile);

    /// Whether the scene has a surface test (nt or sht).
    void configure(bool has_surface_test) { has_surface_test_ = has_surface_test; }

    /// Step 1 for every edge.
    void decide(Span<Edge<P>> edges) const;

    /// Steps 2 and 3 for a triangle and its three decided edges. The children refer to both.
    void tessellate(const Triangle<P>& triangle, const Edge<P>* edges, Children<P>& children);

    /// One item of the unit: a beat for each child, or one for the triangle that passes.
    SplitBeats operator()(const SplitIn& in);

    const SplitCounters& counters() const { return counters_; }
    void reset() { counters_ = {}; }

private:
    bool first_diagonal_is_shorter(const Vertex<P>& a, const Vertex<P>& m1, const Vertex<P>& b,
                                   const Vertex<P>& m2);
    typename P::Wide squared_length(const Vec3<V>& p, const Vec3<V>& q);

    Cast to_diagonal_;
    bool has_surface_test_ = true;
    SplitCounters counters_;
};

}  // namespace repousse
