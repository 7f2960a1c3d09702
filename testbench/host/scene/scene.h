#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "datapath/error.h"
#include "datapath/map_view.h"
#include "datapath/sweep_items.h"
#include "datapath/units/height_test.h"
#include "datapath/units/normal_test.h"
#include "datapath/units/triangle_stack.h"
#include "testbench/host/map/filter_levels.h"
#include "testbench/host/map/procedural_map.h"
#include "testbench/host/map/range_map.h"

namespace repousse::host {

/// A place in the scene file, for messages about what was read there.
struct SceneMark {
    std::string file;
    int line = 0;
    int column = 0;

    std::string text() const {
        return file + ":" + std::to_string(line) + ":" + std::to_string(column);
    }
};

/// Size of the picture.
struct Viewport {
    int width_px = 1280;
    int height_px = 720;
};

/// A pinhole camera. World units; the vertical field of view in degrees.
struct CameraSettings {
    glm::dvec3 eye{0.0, -2.0, 1.5};
    glm::dvec3 target{0.0};
    glm::dvec3 up{0.0, 0.0, 1.0};
    double fov_deg = 40.0;
    double near = 0.01;
    double far = 100.0;
};

/// A directional light. Colours are sRGB, 0..1 a channel (lights may exceed 1).
struct Light {
    glm::dvec3 direction{0.0, 0.0, 1.0};  ///< unit, towards the light
    glm::dvec3 colour{1.0};
};

enum class Tint { Plain, Relief };
enum class Shading { Smooth, Flat };

/// How the frame is drawn; nothing here reaches the device.
struct ViewSettings {
    bool wireframe = false;
    bool shadows = false;
    bool skirt = false;  ///< close the border of an open mesh down to the lowest height
    Tint tint = Tint::Plain;
    Shading shading = Shading::Smooth;
    glm::dvec3 background{0.93, 0.94, 0.96};  ///< sRGB, top of the picture
    glm::dvec3 horizon{0.93, 0.94, 0.96};     ///< sRGB, bottom of the picture
    glm::dvec3 colour{0.72, 0.70, 0.66};      ///< of the surface, with Tint::Plain
    int samples = 2;                          ///< supersampling: samples x samples a pixel
};

enum class MeshKind { File, Grid, Cylinder, Icosphere };
enum class UvProjection { None, Planar, Spherical, Cylindrical };

/// Where a base mesh comes from.
struct MeshSource {
    MeshKind kind = MeshKind::Grid;
    std::string file;  ///< resolved path, MeshKind::File only
    UvProjection projection = UvProjection::None;
    int columns = 1;  ///< grid: quads across; cylinder: segments round
    int rows = 1;     ///< grid: quads up; cylinder: quads along the height
    glm::dvec2 size{1.0, 1.0};
    double radius = 1.0;
    double height = 1.0;
    int subdivisions = 2;
    double turn_deg = 0.0;        ///< about the z axis, counter-clockwise from above
    glm::dvec3 translation{0.0};  ///< world units, after the turn
    SceneMark mark;
};

enum class MapKind { File, Donut, Constant, Ramp, Checker, Fbm, Range };

/// A procedural map, or the file to read one from.
struct MapRecipe {
    MapKind kind = MapKind::Constant;
    std::string file;  ///< resolved path: of a map (MapKind::File), of a mesh (Range)
    int width = 256;   ///< of a map that is made, texels
    int height = 256;
    RangeAxis axis;  ///< range
    int value = 0;   ///< constant
    int start = 0;   ///< ramp
    int slope_x = 0;
    int slope_y = 0;
    int square = 16;  ///< checker
    int low = 0;
    int high = 65535;
    FbmSettings fbm;
    SceneMark mark;
};

/// What uv 0..1 spans: the map from border to border, from the first texel's centre to the last
/// one's, or one turn round (u as Edges, v as Centres).
enum class UvSpan { Edges, Centres, Turn };

struct TexelBox {
    int x = 0, y = 0, width = 0, height = 0;
};

/// A displacement map and how it is read.
struct MapSource {
    MapRecipe recipe;
    bool used_fallback = false;          ///< the file named by the scene is absent
    std::string missing_file;            ///< its name as written, with used_fallback
    std::optional<TexelBox> crop;        ///< applied first
    std::optional<glm::ivec2> resample;  ///< then this
    bool flip_rows = false;              ///< then the last row comes to v = 0
    std::optional<glm::dvec2> samples;   ///< declared sample range of the file or range map
    std::optional<double> void_value;    ///< samples of the file that mean: no elevation here
    bool fill_voids = false;             ///< fill them, and NaN; with void_value in any case
    glm::dvec2 range{0.0, 1.0};          ///< world displacement at h = 0 and h = 65535
    bool wrap = false;
    HeightFilter filter = HeightFilter::Nearest;
    std::optional<LevelFilter> levels;  ///< filter levels to read from; absent: the map alone
    int finer_levels = 0;               ///< below that of a footprint, 0..kMostFiner
    UvSpan uv = UvSpan::Edges;
    SceneMark mark;
};

// The device's own settings: what a scene says needs no translation.
using repousse::BoxKind;
using repousse::HeightFilter;
using repousse::HeightMode;
using repousse::NormalSpace;
using repousse::StackOrder;

/// Settings of adaptive tessellation (Doggett and Hirche). A test without a threshold is not
/// part of the effect and its unit is not built.
struct AdaptiveSettings {
    std::optional<int> generation_cap;  ///< 0..15; absent = the natural cap
    StackOrder order = StackOrder::Lifo;
    bool eager = false;
    BoxKind box = BoxKind::Square;
    HeightMode height_mode = HeightMode::Average;
    /// Average: height LSB, 0..65535. Sum: height LSB x texel^2, 0..2^38.
    std::optional<double> height_threshold;
    std::optional<double> normal_threshold;  ///< 0..2
    NormalSpace normal_space = NormalSpace::World;
    std::optional<double> view_threshold_px;  ///< 0..4096
    bool uniform = false;  ///< no height or normal test: split all that ct and the cap allow
    int contexts = 1;      ///< 1..16
};

/// Settings of sweep-line remeshing (Gumhold and Huettner). One *grid unit* is `coarseness_px`
/// pixels at every distance, and as deep as it is wide.
struct SweepSettings {
    double coarseness_px = 1.0;
    int guard_grid = kGridLimit;  ///< corners are clamped to +- this many grid units, 1..4096
    std::optional<double> w_min;  ///< world units: nearer points count as this near; absent: near
    bool clip = true;             ///< reject triangles outside the extended view volume
};

/// What the device does with an object's triangles.
enum class Method {
    Adaptive,  ///< tessellated recursively by tests
    Sweep,     ///< remeshed to the size of pixels by sweep lines
    Direct,    ///< drawn as they are: not displaced
};

/// The method as a scene writes it.
const char* method_name(Method method);

/// What a surface does with light in the device's unit `shade` (Phong). Colours are sRGB, 0..1.
struct Material {
    glm::dvec3 ambient{0.20};  ///< as it leaves the surface where no light falls
    glm::dvec3 diffuse{0.72, 0.70, 0.66};
    glm::dvec3 specular{0.35};
    int shininess = 40;      ///< the highlight's exponent, 1..255
    bool two_sided = false;  ///< lit on the side that the viewer sees
    SceneMark mark;
};

/// One object.
struct Object {
    std::string name;
    Method method = Method::Adaptive;
    MeshSource mesh;
    MapSource map;  ///< Method::Direct: one texel without displacement
    AdaptiveSettings adaptive;
    SweepSettings sweep;
    bool bump = false;              ///< displaced normals are wanted in the output
    std::optional<Material> shade;  ///< the device colours the vertices
    SceneMark mark;
};

/// A scene, validated: every number is in its range, every file it names exists (or its fallback
/// is in use).
struct Scene {
    std::string file;  ///< path as given
    std::string title;
    std::string profile = "default";
    Viewport viewport;
    CameraSettings camera;
    std::vector<Light> lights;
    ViewSettings view;
    std::vector<Object> objects;
    std::vector<std::string> notes;  ///< e.g. that a fallback map is in use
};

/// Reads and validates a scene (format: docs/scene.md). Nothing but the scene file is read; files
/// it names are only looked for. Every error names file:line:column.
Result<Scene> read_scene(const std::string& path);

/// As above, from text; `name` stands in messages, `folder` is where relative files are sought.
Result<Scene> parse_scene(const std::string& text, const std::string& name,
                          const std::string& folder);

}  // namespace repousse::host
