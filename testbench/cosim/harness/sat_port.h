#pragma once

#include <array>

#include "testbench/cosim/harness/harness.h"

namespace repousse::harness {

/// The read port of a unit with a height_test in it, three entries of the summed-area table a
/// request: what ReadPort asks of a `Unit`, which derives from this.
struct SatPort {
    static constexpr int kReadEntries = 3;

    static void drive_memory(Vunit& top, bool ready, bool rvalid, const uint64_t* rdata) {
        top.sat_ready = ready;
        top.sat_rvalid = rvalid;
        if (!rvalid) return;
        std::array<int64_t, kReadEntries> words{};  // the last entry first
        for (int entry = 0; entry < kReadEntries; ++entry) {
            words[std::size_t(kReadEntries - 1 - entry)] = static_cast<int64_t>(rdata[entry]);
        }
        drive_vector<SAT_WIDTH>(top.sat_rdata, words.data(), kReadEntries);
    }

    static bool requests(const Vunit& top) { return top.sat_valid; }
    static bool takes_answer(const Vunit& top) { return top.sat_rready; }
    static bool wants(const Vunit& top, int entry) { return top.sat_read >> entry & 1; }
    static Address address(const Vunit& top, int entry) {
        const int low = 13 * entry;
        return {static_cast<uint32_t>(top.sat_x >> low & 0x1fff),
                static_cast<uint32_t>(top.sat_y >> low & 0x1fff)};
    }
};

}  // namespace repousse::harness
