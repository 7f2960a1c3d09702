#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "datapath/items.h"
#include "datapath/numbers/policy.h"
#include "datapath/profile.h"
#include "datapath/span.h"
#include "datapath/transaction.h"
#include "datapath/units/normal_test_desc.h"

namespace repousse {

/// In which space the normal test compares.
enum class NormalSpace : uint8_t {
    World,  ///< N', as printed
    Map,    ///< N_D and N apart: invariant where mirrored texture coordinates meet at a seam
};

/// The normals of a vertex that the Normal Test looks at.
struct VertexNormals {
    Vec3<int32_t> displaced_normal, map_normal, normal;
};

/// One edge as it enters the Normal Test: the input ports of the description.
struct NormalTestIn {
    bool skip = false;
    std::array<VertexNormals, 3> vertices;  ///< end 1, end 2, the midpoint

    std::array<Word, 28> pack() const {
        std::array<Word, 28> words{skip};
        std::size_t at = 1;
        for (const VertexNormals& v : vertices) {
            for (const Vec3<int32_t>& n : {v.displaced_normal, v.map_normal, v.normal}) {
                words[at++] = n.x, words[at++] = n.y, words[at++] = n.z;
            }
        }
        return words;
    }
    static NormalTestIn unpack(const Word* w) {
        NormalTestIn in{*w++ != 0, {}};
        for (VertexNormals& v : in.vertices) {
            for (Vec3<int32_t>* n : {&v.displaced_normal, &v.map_normal, &v.normal}) {
                for (int32_t* c : {&n->x, &n->y, &n->z}) *c = static_cast<int32_t>(*w++);
            }
        }
        return in;
    }
};
static_assert(ports_are(kNormalTestDesc, PortKind::Input,
                        {"skip",
                         "displaced_normal1_x",
                         "displaced_normal1_y",
                         "displaced_normal1_z",
                         "map_normal1_x",
                         "map_normal1_y",
                         "map_normal1_z",
                         "normal1_x",
                         "normal1_y",
                         "normal1_z",
                         "displaced_normal2_x",
                         "displaced_normal2_y",
                         "displaced_normal2_z",
                         "map_normal2_x",
                         "map_normal2_y",
                         "map_normal2_z",
                         "normal2_x",
                         "normal2_y",
                         "normal2_z",
                         "displaced_normal12_x",
                         "displaced_normal12_y",
                         "displaced_normal12_z",
                         "map_normal12_x",
                         "map_normal12_y",
                         "map_normal12_z",
                         "normal12_x",
                         "normal12_y",
                         "normal12_z"}));
static_assert(ports_are(kNormalTestDesc, PortKind::Config, {"threshold", "map_space"}));

/// What the Normal Test says of it.
struct NormalTestOut {
    bool nt = false;

    std::array<Word, 1> pack() const { return {nt}; }
};
static_assert(ports_are(kNormalTestDesc, PortKind::Output, {"nt"}));

/// The Surface Normal Variance Test (Doggett and Hirche 2.2, 3.1.4; the printed comparison lacks
/// the absolute value and has its sense turned): nt = some component of N' at the midpoint differs
/// from that at either end by more than the threshold, strictly.
///
/// Six absolute differences and comparisons; twelve in map space. Symmetric in both ends.
template <class P>
class NormalTest {
public:
    using V = typename P::Value;

    explicit NormalTest(const Profile& profile);

    /// `threshold`: 0 to 2, with the fraction bits of `displaced_normal`; as many bits as that,
    /// none of them a sign.
    void configure(V threshold, NormalSpace space);

    bool operator()(const Vertex<P>& v1, const Vertex<P>& v2, const Vertex<P>& mid) const;

    /// One transaction of the unit: a skipped item passes with result 0.
    NormalTestOut operator()(const NormalTestIn& in) const;

    /// Tests the undecided edges, all of them when eager.
    void run(Span<Edge<P>> edges, bool eager);

    const TestCounters& counters() const { return counters_; }
    void reset() { counters_ = {}; }

private:
    int align_map_;   // from displaced_normal's fraction to map_normal's; negative if coarser
    int align_base_;  // from displaced_normal's fraction to normal's
    typename P::Wide threshold_{};
    typename P::Wide map_threshold_{};
    typename P::Wide base_threshold_{};
    NormalSpace space_ = NormalSpace::World;
    TestCounters counters_;
};

}  // namespace repousse
