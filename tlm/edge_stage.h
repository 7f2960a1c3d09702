#pragma once

#include "datapath/items.h"
#include "datapath/numbers/policy.h"
#include "datapath/span.h"
#include "datapath/units/split.h"
#include "tlm/stage.h"

namespace repousse::shell {

/// What adaptive tessellation hands on. A batch on its way through the tests: up to
/// kBatchTriangles triangles, three edges each.
struct EdgeBatch {
    Span<const Triangle<Fixed>> triangles;
    Span<Edge<Fixed>> edges;
};

using EdgePlace = Place<EdgeBatch>;
using EdgeCall = Call<EdgeBatch>;

/// The corners of a base triangle, which are displaced before its first tests.
using BaseCall = Call<Triangle<Fixed>>;

/// What the stack asks for when the edges of a batch are decided and their vertices complete.
class ChildrenSource : public virtual sc_core::sc_interface {
public:
    /// What a triangle turns into, given its three edges.
    virtual void tessellate(const Triangle<Fixed>& triangle, const Edge<Fixed>* edges,
                            Children<Fixed>& children) = 0;
};

}  // namespace repousse::shell
