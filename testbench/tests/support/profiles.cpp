#include "testbench/tests/support/profiles.h"

#include <cstdio>
#include <cstdlib>

#include "tlm/config/profile_reader.h"

namespace repousse::test {

Profile profile_with(const std::string& shipped,
                     const std::vector<std::pair<std::string, std::string>>& replaced) {
    const Result<Profile> base = shipped_profile(shipped);
    if (!base) {
        std::fprintf(stderr, "%s\n", base.error().message().c_str());
        std::abort();
    }
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const ProfileEntry& entry : profile_entries()) {
        std::string value = entry_text(*base, entry);
        for (const auto& [key, other] : replaced) {
            if (key == entry.key) value = other;
        }
        pairs.emplace_back(entry.key, value);
    }
    const Result<Profile> profile = make_profile(pairs);
    if (!profile) {
        std::fprintf(stderr, "%s\n", profile.error().message().c_str());
        std::abort();
    }
    return *profile;
}

}  // namespace repousse::test
