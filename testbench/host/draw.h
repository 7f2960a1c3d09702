#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "datapath/error.h"
#include "datapath/pipelines/draw.h"
#include "datapath/profile.h"
#include "testbench/host/map/height_map.h"
#include "testbench/host/mesh/mesh.h"
#include "testbench/host/scene/scene.h"
#include "testbench/host/view/camera.h"

namespace repousse::host {

/// An object, loaded, with everything that decides how it is tessellated.
struct DrawInputs {
    const Mesh* mesh = nullptr;
    const HeightMap* map = nullptr;
    Method method = Method::Adaptive;
    AdaptiveSettings settings;
    SweepSettings sweep;
    HeightFilter filter = HeightFilter::Nearest;
    std::optional<LevelFilter> levels;  ///< filter levels that `filter` reads
    int finer_levels = 0;               ///< levels below that of a footprint, for Maximum
    UvSpan uv = UvSpan::Edges;
    bool bump = false;              ///< displaced normals are wanted in the output
    std::optional<Material> shade;  ///< colours are wanted
    std::vector<Light> lights;      ///< of the scene
    glm::dvec2 texel_size{0.0};     ///< world units a texel, for the finite differences
    ViewFrame view;
    CameraSettings camera;  ///< `view` is its frame on this viewport
    Viewport viewport;
};

/// How an object of a scene is tessellated; refers to its mesh and map.
DrawInputs draw_inputs(const Scene& scene, const Object& object, const Mesh& mesh,
                       const HeightMap& map);

/// Texture coordinates of a mesh vertex in texels, truncated to the format's fraction bits.
Uv texel_uv(glm::dvec2 uv, const HeightMap& map, UvSpan span, int frac);

/// The natural generation cap: ceil(log2(longest base edge, L-infinity, in texels)); regular 1:4
/// refinement reaches one texel exactly there. At most 15.
int natural_cap(const DrawInputs& inputs, int uv_frac);

/// The profile whose integers level `ref` uses: the topology of `profile`, full heights.
Profile reference_profile(Profile profile);

/// Brings an object into the device's formats: level `ref` with P = Real, bit-accurate with Fixed.
/// For Real pass the reference_profile. Only the tables that the settings call for are made.
/// Errors: a position, texture coordinate, edge or register that the profile cannot hold.
template <class P>
Result<AdaptiveDraw<P>> make_draw(const Profile& profile, const DrawInputs& inputs);

}  // namespace repousse::host
