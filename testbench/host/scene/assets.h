#pragma once

#include <functional>
#include <string>

#include "datapath/error.h"
#include "testbench/host/map/height_map.h"
#include "testbench/host/mesh/mesh.h"
#include "testbench/host/scene/scene.h"

namespace repousse::host {

/// Reads an image file into samples. `samples` is the declared range of a float image, if any.
/// The program passes `read_image_grid` of testbench/host/image; a program without images passes
/// an empty function, and a scene that names an image is then refused with a clear message.
using ImageReader = std::function<Result<ElevationGrid>(const std::string& path,
                                                        std::optional<glm::dvec2> samples)>;

/// The object's base mesh, complete: normals, tangents, handedness and UV are all present, and
/// world_per_uv is set. Errors in a mesh file also name the scene line.
Result<Mesh> load_mesh(const Object& object);

/// The object's displacement map: read or made, cropped, resampled, range and wrap set.
/// Errors in a map file also name the scene line.
Result<HeightMap> load_map(const Object& object, const ImageReader& image_reader);

/// Texel coordinates of a uv position: uv * size (UvSpan::Edges, texel i covers [i, i + 1)), or
/// uv * (size - 1) + .5 (UvSpan::Centres, uv 0 and 1 are the first and last texel's centre).
glm::dvec2 texel_coordinate(glm::dvec2 uv, const HeightMap& map, UvSpan span);

/// The uv position of texel coordinates: the inverse.
glm::dvec2 map_uv(glm::dvec2 texel, const HeightMap& map, UvSpan span);

/// World size of one texel on this mesh, as `normal_map` wants it.
glm::dvec2 texel_size(const Mesh& mesh, const HeightMap& map, UvSpan span);

}  // namespace repousse::host
