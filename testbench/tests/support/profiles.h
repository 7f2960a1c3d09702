#pragma once

#include <string>
#include <utility>
#include <vector>

#include "datapath/profile.h"

namespace repousse::test {

/// A shipped profile with some entries replaced; aborts the test program if that is not possible.
Profile profile_with(const std::string& shipped,
                     const std::vector<std::pair<std::string, std::string>>& replaced);

}  // namespace repousse::test
