#pragma once

#include <variant>
#include <vector>

#include "datapath/error.h"
#include "datapath/pipelines/contexts.h"
#include "datapath/pipelines/draw.h"
#include "datapath/pipelines/sweep_draw.h"
#include "testbench/app/job.h"
#include "testbench/app/run_levels.h"

namespace repousse::app {

/// What the device gets for an object, by the object's method. With Fixed: shell::Draw.
template <class P>
using ObjectDraw = std::variant<AdaptiveDraw<P>, SweepDraw<P>>;

/// What it makes of it. With Fixed: shell::DrawOutput.
template <class P>
using ObjectOutput = std::variant<std::vector<OutputTriangle<P>>, SweepMesh<P>>;

/// The draws of a job's objects, in their order. Errors name the object's place in the scene.
template <class P>
Result<std::vector<ObjectDraw<P>>> make_draws(const Job& job, const Profile& profile);

/// Runs one draw through the bare units and adds what they counted.
template <class P>
ObjectOutput<P> run_bare(const Profile& profile, const ObjectDraw<P>& draw,
                         std::vector<CounterRow>& counters);

/// What object `i` turned into: its surface and, if `check`, what the invariants say of it.
template <class P>
ObjectResult object_result(const Job& job, std::size_t i, const Profile& profile,
                           const ObjectDraw<P>& draw, const ObjectOutput<P>& output, bool check);

/// Bytes of the maps and tables that were made for a draw.
template <class P>
uint64_t table_bytes(const ObjectDraw<P>& draw);

}  // namespace repousse::app
