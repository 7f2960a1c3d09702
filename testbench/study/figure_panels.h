#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "testbench/host/scene/scene.h"
#include "testbench/host/view/picture.h"
#include "testbench/host/view/render_mesh.h"

namespace repousse::study {

/// Shades of a channel in a document's pictures: few, so that the files are small.
inline constexpr int kShades = 64;      ///< no banding that one sees
inline constexpr int kLineShades = 16;  ///< of what is mostly lines

/// Pictures in rows; those of a row are of one height. White lies between them. Every channel is
/// rounded to one of `shades` levels.
host::Picture panels(const std::vector<std::vector<host::Picture>>& rows, int shades = kShades);

/// The mean of each block of `factor` x `factor` pixels.
host::Picture reduced(const host::Picture& picture, int factor);

/// A surface as a scene shows it.
host::Picture shaded(const host::Scene& scene, const std::vector<host::RenderMesh>& surfaces,
                     const host::CameraSettings& camera, const host::Viewport& viewport);

/// The edges of its triangles, hidden ones removed, on a pale surface.
host::Picture wireframe(const std::vector<host::RenderMesh>& surfaces,
                        const host::CameraSettings& camera, const host::Viewport& viewport);

/// The camera moved along its view to `times` its distance from the target.
host::CameraSettings farther(host::CameraSettings camera, double times);

/// Thousands in groups: 1,234,567.
std::string grouped(std::size_t number);

}  // namespace repousse::study
