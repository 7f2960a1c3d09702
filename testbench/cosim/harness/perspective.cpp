// The engine of rtl/units/perspective.sv.
#include "testbench/cosim/harness/harness.h"

namespace repousse::harness {
namespace {

struct PerspectiveUnit {
    static constexpr const char* kName = "perspective";
    static constexpr int kConfigs = 1;
    static constexpr int kInputs = 13;
    static constexpr int kOutputs = 13;
    static constexpr int kReadEntries = 0;

    static void configure(Vunit& top, const int64_t* config) { top.tangents = bits<1>(config[0]); }

    static void drive(Vunit& top, const int64_t* in) {
        top.x_c = bits<SWEEP_DATA_WIDTH>(in[0]);
        top.y_c = bits<SWEEP_DATA_WIDTH>(in[1]);
        top.z_c = bits<SWEEP_DATA_WIDTH>(in[2]);
        top.nx_c = bits<SWEEP_DATA_WIDTH>(in[3]);
        top.ny_c = bits<SWEEP_DATA_WIDTH>(in[4]);
        top.nz_c = bits<SWEEP_DATA_WIDTH>(in[5]);
        top.uv_x_c = bits<SWEEP_DATA_WIDTH>(in[6]);
        top.uv_y_c = bits<SWEEP_DATA_WIDTH>(in[7]);
        top.c = bits<INVERSE_W_WIDTH>(in[8]);
        top.tx_c = bits<SWEEP_DATA_WIDTH>(in[9]);
        top.ty_c = bits<SWEEP_DATA_WIDTH>(in[10]);
        top.tz_c = bits<SWEEP_DATA_WIDTH>(in[11]);
        top.handedness_c = bits<SWEEP_DATA_WIDTH>(in[12]);
    }

    static void sample(const Vunit& top, int64_t* out) {
        out[0] = extended<POSITION_WIDTH>(top.x);
        out[1] = extended<POSITION_WIDTH>(top.y);
        out[2] = extended<POSITION_WIDTH>(top.z);
        out[3] = extended<UNNORMALISED_WIDTH>(top.nx);
        out[4] = extended<UNNORMALISED_WIDTH>(top.ny);
        out[5] = extended<UNNORMALISED_WIDTH>(top.nz);
        out[6] = extended<UV_WIDTH>(top.uv_x);
        out[7] = extended<UV_WIDTH>(top.uv_y);
        out[8] = extended<UNNORMALISED_WIDTH>(top.tx);
        out[9] = extended<UNNORMALISED_WIDTH>(top.ty);
        out[10] = extended<UNNORMALISED_WIDTH>(top.tz);
        out[11] = top.left_handed;
        out[12] = top.clamped;
    }
};

}  // namespace
}  // namespace repousse::harness

const RepousseEngine* repousse_engine() {
    return repousse::harness::engine<repousse::harness::PerspectiveUnit>();
}
