#pragma once

#include "datapath/error.h"
#include "datapath/pipelines/sweep_draw.h"
#include "datapath/profile.h"
#include "testbench/host/draw.h"

namespace repousse::host {

/// Brings an object of method `sweep` or `direct` into the device's formats: level `ref` with
/// P = Real, bit-accurate with Fixed. For Real pass the reference_profile. What follows from the
/// camera and the object together:
///
///  - z_offset puts the object's depths, in grid units, around 0, so that the guard band is spent
///    on the object and not on the way to it;
///  - w_scale is the least w of the object's vertices, so that c uses its format up to 1;
///  - every base triangle gets the largest displacement of the texels under it, or, with filter
///    levels, of the map and all its levels.
///
/// Errors: a position, texture coordinate or register that the profile cannot hold; displaced
/// normals with a profile whose registers have no place for tangents.
template <class P>
Result<SweepDraw<P>> make_sweep_draw(const Profile& profile, const DrawInputs& inputs);

}  // namespace repousse::host
