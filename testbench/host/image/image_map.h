#pragma once

#include <optional>
#include <string>

#include <glm/vec2.hpp>

#include "datapath/error.h"
#include "testbench/host/map/height_map.h"

namespace repousse::host {

/// Reads the first channel of an image as an elevation grid, row 0 of the file at v = 0.
/// 8- and 16-bit integers span their whole type (0..255 or 0..65535, so 16-bit samples pass
/// unchanged); signed 16-bit and float images span `samples` if declared, their own smallest and
/// largest otherwise. A declared range holds for the unsigned types too.
///
/// The header is judged before a pixel is read: sides 1..kMaxMapSide (16384), so an image that
/// claims 100,000 x 100,000 costs nothing. Errors (kind Input): missing file, empty file, an
/// unknown or damaged format, a volume or deep image. NaN and infinite texels stay (voids.h).
Result<ElevationGrid> read_image_grid(const std::string& path, std::optional<glm::dvec2> samples);

}  // namespace repousse::host
