#pragma once

#include <cstdint>

#include "datapath/items.h"
#include "datapath/numbers/policy.h"
#include "datapath/profile.h"
#include "datapath/span.h"
#include "datapath/transaction.h"

namespace repousse {

/// In which space the normal test compares.
enum class NormalSpace : uint8_t {
    World,  ///< N', as printed
    Map,    ///< N_D and N apart: invariant where mirrored texture coordinates meet at a seam
};

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
