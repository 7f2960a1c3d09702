#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "testbench/study/bump_error.h"

namespace repousse::study {

/// The angle between a normal of the device and the same one in double, over many random vectors.
struct NormaliseError {
    std::string profile;
    int kind = 0;      ///< NormaliseKind
    std::string what;  ///< where in the device, of which vectors
    double max_deg = 0;
    double rms_deg = 0;
};

/// The same against the length of the vector before it is rounded to `unnormalised`.
struct ShortVectors {
    std::string profile;
    double length_lsb = 0;   ///< of `unnormalised`
    double max_deg[2] = {};  ///< by kind
    double bound_deg = 0;    ///< of the roundings before and behind
};

/// Cycles of a vector through each kind.
struct NormaliseCycles {
    std::string profile;
    int latency[2] = {};
};

struct NormaliseReport {
    static constexpr int kVectors = 200'000;  ///< in each row
    uint64_t seed = 1;
    std::vector<NormaliseError> errors;
    std::vector<BumpError> bumps;  ///< all three kinds
    std::vector<ShortVectors> lengths;
    std::vector<NormaliseCycles> cycles;
};

/// Both shipped profiles and both kinds; the same seed gives the same report.
NormaliseReport normalise_study(uint64_t seed);

/// The report as docs/normalise.md.
std::string normalise_markdown(const NormaliseReport& report);

}  // namespace repousse::study
