#pragma once

#include "datapath/error.h"
#include "datapath/profile.h"
#include "datapath/units/shade.h"
#include "testbench/host/draw.h"

namespace repousse::host {

/// The registers of `shade` for an object with a material: the scene's lights times its colours,
/// in linear light, and the eye. Level `ref` with P = Real, bit-accurate with Fixed. Errors, at the
/// material's place in the scene: more lights than the profile has, and a product that the format
/// `light` cannot hold.
template <class P>
Result<ShadeRegisters<P>> make_shade_registers(const Profile& profile, const DrawInputs& inputs);

/// A raw colour of the unit, or one of level `ref`, as linear light; brighter than white is white.
template <class P>
glm::dvec3 linear_light(const Colour<typename P::Value>& colour, const Profile& profile);

}  // namespace repousse::host
