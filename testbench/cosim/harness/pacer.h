#pragma once

#include <cstdint>

#include "testbench/cosim/random.h"
#include "tlm/engine.h"

namespace repousse::harness {

using cosim::Random;

/// Says, cycle by cycle, whether one side of a handshake is willing to act.
class Pacer {
public:
    Pacer() = default;
    explicit Pacer(RepoussePace pace) : pace_(pace) {}

    bool willing(Random& random) {
        if (pace_.percent >= 100) return true;
        if (left_ == 0) {
            left_ = pace_.burst;
            open_ = random.percent(pace_.percent);
        }
        --left_;
        return open_;
    }

private:
    RepoussePace pace_{100, 1};
    uint32_t left_ = 0;
    bool open_ = true;
};

}  // namespace repousse::harness
