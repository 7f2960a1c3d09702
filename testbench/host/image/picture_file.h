#pragma once

#include <string>

#include "datapath/error.h"
#include "testbench/host/view/picture.h"

namespace repousse::host {

/// Writes a picture as 8-bit sRGB PNG, beside and renamed. No time stamps or program names go in,
/// so the same picture gives the same bytes. Errors: kind Environment.
Status write_png(const std::string& path, const Picture& picture);

/// Writes a picture as OpenEXR, half floats in linear light, ZIP, beside and renamed.
Status write_exr(const std::string& path, const Picture& picture);

}  // namespace repousse::host
