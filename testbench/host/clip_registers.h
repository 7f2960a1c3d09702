#pragma once

#include "datapath/error.h"
#include "datapath/profile.h"
#include "datapath/units/view_clip.h"
#include "testbench/host/scene/scene.h"

namespace repousse::host {

/// The registers of `view_clip` for a camera: its view volume, so that nothing visible on the
/// surface in world units is rejected by what the device rounds. In particular
///
///  - the device's camera rows are rounded, so a visible point stands up to a tiny angle outside
///    of the true view in the device's eye space: the planes are turned outwards by that angle and
///    near and far moved;
///  - the eye, the base vertices and their eye coordinates are rounded: that is `margin`;
///  - sine and cosine are rounded so that the plane is turned outwards and is not longer than one.
///
/// Values beyond the formats are saturated, inwards for near and outwards for far, which rejects
/// less. With Real: the exact planes and no margin.
template <class P>
ClipRegisters<P> make_clip_registers(const Profile& profile, const CameraSettings& camera,
                                     const Viewport& viewport);

/// The value for `max_displacement` of a base triangle on which |D| <= d (world units): rounded
/// up, and lengthened by what rounded normals and camera rows may be longer than one. Error: it
/// does not fit the profile's `displacement`.
template <class P>
Result<typename P::Value> max_displacement_register(const Profile& profile, double d);

}  // namespace repousse::host
