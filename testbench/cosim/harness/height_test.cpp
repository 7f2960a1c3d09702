// The engine of rtl/units/height_test.sv.
#include "testbench/cosim/harness/sat_port.h"

namespace repousse::harness {
namespace {

struct HeightTestUnit : SatPort {
    static constexpr const char* kName = "height_test";
    static constexpr int kConfigs = 6;
    static constexpr int kInputs = 7;
    static constexpr int kOutputs = 1;

    static void configure(Vunit& top, const int64_t* config) {
        top.map_width = bits<13>(config[0]);
        top.map_height = bits<13>(config[1]);
        top.wrap = bits<1>(config[2]);
        top.literal = bits<1>(config[3]);
        top.sum = bits<1>(config[4]);
        top.threshold = bits<SAT_WIDTH>(config[5]);
    }

    static void drive(Vunit& top, const int64_t* in) {
        top.skip = bits<1>(in[0]);
        top.u1_x = bits<UV_WIDTH>(in[1]);
        top.u1_y = bits<UV_WIDTH>(in[2]);
        top.u2_x = bits<UV_WIDTH>(in[3]);
        top.u2_y = bits<UV_WIDTH>(in[4]);
        top.u12_x = bits<UV_WIDTH>(in[5]);
        top.u12_y = bits<UV_WIDTH>(in[6]);
    }

    static void sample(const Vunit& top, int64_t* out) { out[0] = top.sht; }
};

}  // namespace
}  // namespace repousse::harness

const RepousseEngine* repousse_engine() {
    return repousse::harness::engine<repousse::harness::HeightTestUnit>();
}
