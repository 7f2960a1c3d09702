// The engine of rtl/units/displace.sv.
#include "testbench/cosim/harness/harness.h"

namespace repousse::harness {
namespace {

struct DisplaceUnit {
    static constexpr const char* kName = "displace";
    static constexpr int kConfigs = 9;
    static constexpr int kInputs = 12;
    static constexpr int kOutputs = 3;
    static constexpr int kReadEntries = 1;

    static void configure(Vunit& top, const int64_t* config) {
        top.map_width = bits<15>(config[0]);
        top.map_height = bits<15>(config[1]);
        top.wrap = bits<1>(config[2]);
        top.filter = bits<2>(config[3]);
        top.finer = bits<2>(config[4]);
        top.minima = bits<1>(config[5]);
        top.scale_mantissa = bits<25>(config[6]);
        top.scale_exponent = bits<6>(config[7]);
        top.bias = bits<DISPLACEMENT_WIDTH>(config[8]);
    }

    static void drive(Vunit& top, const int64_t* in) {
        top.p_x = bits<POSITION_WIDTH>(in[0]);
        top.p_y = bits<POSITION_WIDTH>(in[1]);
        top.p_z = bits<POSITION_WIDTH>(in[2]);
        top.n_x = bits<NORMAL_WIDTH>(in[3]);
        top.n_y = bits<NORMAL_WIDTH>(in[4]);
        top.n_z = bits<NORMAL_WIDTH>(in[5]);
        top.u_x = bits<UV_WIDTH>(in[6]);
        top.u_y = bits<UV_WIDTH>(in[7]);
        top.reach_x = bits<UV_WIDTH>(in[8]);
        top.reach_y = bits<UV_WIDTH>(in[9]);
        top.level = bits<4>(in[10]);
        top.back = bits<1>(in[11]);
    }

    static void sample(const Vunit& top, int64_t* out) {
        out[0] = extended<POSITION_WIDTH>(top.displaced_x);
        out[1] = extended<POSITION_WIDTH>(top.displaced_y);
        out[2] = extended<POSITION_WIDTH>(top.displaced_z);
    }

    static void drive_memory(Vunit& top, bool ready, bool rvalid, const uint64_t* rdata) {
        top.texel_ready = ready;
        top.texel_rvalid = rvalid;
        if (rvalid) top.texel_rdata = bits<HEIGHT_WIDTH>(static_cast<int64_t>(rdata[0]));
    }

    static bool requests(const Vunit& top) { return top.texel_valid; }
    static bool takes_answer(const Vunit& top) { return top.texel_rready; }
    static bool wants(const Vunit&, int) { return true; }
    /// All levels stand below each other in one table of as many columns as the map's, then the
    /// minima of levels 1 to 14 (displace_cases.cpp).
    static Address address(const Vunit& top, int) {
        constexpr uint32_t kMostLevels = 14;
        const auto rows = [&top](uint32_t level) {
            return (static_cast<uint32_t>(top.map_height) + (1U << level) - 1) >> level;
        };
        uint32_t first = 0;
        for (uint32_t l = 0; l < top.texel_level; ++l) first += rows(l);
        for (uint32_t l = 1; top.texel_minimum && l <= kMostLevels; ++l) first += rows(l);
        return {static_cast<uint32_t>(top.texel_x), first + static_cast<uint32_t>(top.texel_y)};
    }
};

}  // namespace
}  // namespace repousse::harness

const RepousseEngine* repousse_engine() {
    return repousse::harness::engine<repousse::harness::DisplaceUnit>();
}
