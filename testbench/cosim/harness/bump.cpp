// The engine of rtl/units/bump.sv.
#include "testbench/cosim/harness/harness.h"

namespace repousse::harness {
namespace {

struct BumpUnit {
    static constexpr const char* kName = "bump";
    static constexpr int kConfigs = 7;
    static constexpr int kInputs = 9;
    static constexpr int kOutputs = 6;
    static constexpr int kReadEntries = 1;
    static constexpr int kTexelBits = BUMP_KIND == 0   ? 3 * MAP_NORMAL_WIDTH
                                      : BUMP_KIND == 1 ? HEIGHT_WIDTH
                                                       : 2 * ANGLE_WIDTH;

    static void configure(Vunit& top, const int64_t* config) {
        top.map_width = bits<15>(config[0]);
        top.map_height = bits<15>(config[1]);
        top.wrap = bits<1>(config[2]);
        top.slope_u_mantissa = bits<25>(config[3]);
        top.slope_u_exponent = bits<6>(config[4]);
        top.slope_v_mantissa = bits<25>(config[5]);
        top.slope_v_exponent = bits<6>(config[6]);
    }

    static void drive(Vunit& top, const int64_t* in) {
        top.u_x = bits<UV_WIDTH>(in[0]);
        top.u_y = bits<UV_WIDTH>(in[1]);
        top.n_x = bits<NORMAL_WIDTH>(in[2]);
        top.n_y = bits<NORMAL_WIDTH>(in[3]);
        top.n_z = bits<NORMAL_WIDTH>(in[4]);
        top.t_x = bits<NORMAL_WIDTH>(in[5]);
        top.t_y = bits<NORMAL_WIDTH>(in[6]);
        top.t_z = bits<NORMAL_WIDTH>(in[7]);
        top.handedness = bits<1>(in[8]);
    }

    static void sample(const Vunit& top, int64_t* out) {
        out[0] = extended<MAP_NORMAL_WIDTH>(top.map_normal_x);
        out[1] = extended<MAP_NORMAL_WIDTH>(top.map_normal_y);
        out[2] = extended<MAP_NORMAL_WIDTH>(top.map_normal_z);
        out[3] = extended<DISPLACED_NORMAL_WIDTH>(top.displaced_normal_x);
        out[4] = extended<DISPLACED_NORMAL_WIDTH>(top.displaced_normal_y);
        out[5] = extended<DISPLACED_NORMAL_WIDTH>(top.displaced_normal_z);
    }

    static void drive_memory(Vunit& top, bool ready, bool rvalid, const uint64_t* rdata) {
        top.texel_ready = ready;
        top.texel_rvalid = rvalid;
        if (rvalid) top.texel_rdata = bits<kTexelBits>(static_cast<int64_t>(rdata[0]));
    }

    static bool requests(const Vunit& top) { return top.texel_valid; }
    static bool takes_answer(const Vunit& top) { return top.texel_rready; }
    static bool wants(const Vunit&, int) { return true; }
    static Address address(const Vunit& top, int) {
        return {static_cast<uint32_t>(top.texel_x), static_cast<uint32_t>(top.texel_y)};
    }
};

}  // namespace
}  // namespace repousse::harness

const RepousseEngine* repousse_engine() {
    return repousse::harness::engine<repousse::harness::BumpUnit>();
}
