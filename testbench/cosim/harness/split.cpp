// The engine of rtl/units/split.sv.
#include "testbench/cosim/harness/harness.h"

namespace repousse::harness {
namespace {

struct SplitUnit {
    static constexpr const char* kName = "split";
    static constexpr int kConfigs = 1;
    static constexpr int kInputs = 23;
    static constexpr int kOutputs = 7;
    static constexpr int kLast = 6;
    static constexpr int kReadEntries = 0;

    static void configure(Vunit& top, const int64_t* config) {
        top.has_surface_test = bits<1>(config[0]);
    }

    static void drive(Vunit& top, const int64_t* in) {
        top.eligible = bits<3>(in[0]);
        top.ct = bits<3>(in[1]);
        top.vt = bits<3>(in[2]);
        top.nt = bits<3>(in[3]);
        top.sht = bits<3>(in[4]);
        top.corner1_x = bits<POSITION_WIDTH>(in[5]);
        top.corner1_y = bits<POSITION_WIDTH>(in[6]);
        top.corner1_z = bits<POSITION_WIDTH>(in[7]);
        top.corner2_x = bits<POSITION_WIDTH>(in[8]);
        top.corner2_y = bits<POSITION_WIDTH>(in[9]);
        top.corner2_z = bits<POSITION_WIDTH>(in[10]);
        top.corner3_x = bits<POSITION_WIDTH>(in[11]);
        top.corner3_y = bits<POSITION_WIDTH>(in[12]);
        top.corner3_z = bits<POSITION_WIDTH>(in[13]);
        top.mid12_x = bits<POSITION_WIDTH>(in[14]);
        top.mid12_y = bits<POSITION_WIDTH>(in[15]);
        top.mid12_z = bits<POSITION_WIDTH>(in[16]);
        top.mid23_x = bits<POSITION_WIDTH>(in[17]);
        top.mid23_y = bits<POSITION_WIDTH>(in[18]);
        top.mid23_z = bits<POSITION_WIDTH>(in[19]);
        top.mid31_x = bits<POSITION_WIDTH>(in[20]);
        top.mid31_y = bits<POSITION_WIDTH>(in[21]);
        top.mid31_z = bits<POSITION_WIDTH>(in[22]);
    }

    static void sample(const Vunit& top, int64_t* out) {
        out[0] = top.digit;
        out[1] = top.vertex1;
        out[2] = top.vertex2;
        out[3] = top.vertex3;
        out[4] = top.unsplit;
        out[5] = top.pass;
        out[6] = top.last;
    }
};

}  // namespace
}  // namespace repousse::harness

const RepousseEngine* repousse_engine() {
    return repousse::harness::engine<repousse::harness::SplitUnit>();
}
