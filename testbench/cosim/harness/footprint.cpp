// The engine of rtl/units/footprint.sv.
#include "testbench/cosim/harness/harness.h"

namespace repousse::harness {
namespace {

struct FootprintUnit {
    static constexpr const char* kName = "footprint";
    static constexpr int kConfigs = 7;
    static constexpr int kInputs = 16;
    static constexpr int kOutputs = 4;
    static constexpr int kReadEntries = 0;

    static void configure(Vunit& top, const int64_t* config) {
        top.map_width = bits<15>(config[0]);
        top.map_height = bits<15>(config[1]);
        top.last_level = bits<4>(config[2]);
        top.finer = bits<2>(config[3]);
        top.eye_x = bits<POSITION_WIDTH>(config[4]);
        top.eye_y = bits<POSITION_WIDTH>(config[5]);
        top.eye_z = bits<POSITION_WIDTH>(config[6]);
    }

    static void drive(Vunit& top, const int64_t* in) {
        top.kind = bits<2>(in[0]);
        top.p_x = bits<POSITION_WIDTH>(in[1]);
        top.p_y = bits<POSITION_WIDTH>(in[2]);
        top.p_z = bits<POSITION_WIDTH>(in[3]);
        top.n_x = bits<NORMAL_WIDTH>(in[4]);
        top.n_y = bits<NORMAL_WIDTH>(in[5]);
        top.n_z = bits<NORMAL_WIDTH>(in[6]);
        top.u_x = bits<UV_WIDTH>(in[7]);
        top.u_y = bits<UV_WIDTH>(in[8]);
        top.c = bits<INVERSE_W_WIDTH>(in[9]);
        top.step0_u = bits<SWEEP_DATA_WIDTH>(in[10]);
        top.step0_v = bits<SWEEP_DATA_WIDTH>(in[11]);
        top.step0_c = bits<INVERSE_W_WIDTH>(in[12]);
        top.step1_u = bits<SWEEP_DATA_WIDTH>(in[13]);
        top.step1_v = bits<SWEEP_DATA_WIDTH>(in[14]);
        top.step1_c = bits<INVERSE_W_WIDTH>(in[15]);
    }

    static void sample(const Vunit& top, int64_t* out) {
        out[0] = extended<UV_WIDTH>(top.reach_x);
        out[1] = extended<UV_WIDTH>(top.reach_y);
        out[2] = top.level;
        out[3] = top.back;
    }
};

}  // namespace
}  // namespace repousse::harness

const RepousseEngine* repousse_engine() {
    return repousse::harness::engine<repousse::harness::FootprintUnit>();
}
