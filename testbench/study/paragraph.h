#pragma once

#include <string>

namespace repousse::study {

/// Prose, broken into lines of at most 100 characters, and an empty line.
std::string paragraph(const std::string& prose);

}  // namespace repousse::study
