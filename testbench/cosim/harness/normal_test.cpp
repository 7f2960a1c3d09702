// The engine of rtl/units/normal_test.sv.
#include "testbench/cosim/harness/harness.h"

namespace repousse::harness {
namespace {

struct NormalTestUnit {
    static constexpr const char* kName = "normal_test";
    static constexpr int kConfigs = 2;
    static constexpr int kInputs = 28;
    static constexpr int kOutputs = 1;
    static constexpr int kReadEntries = 0;

    static void configure(Vunit& top, const int64_t* config) {
        top.threshold = bits<DISPLACED_NORMAL_WIDTH>(config[0]);
        top.map_space = bits<1>(config[1]);
    }

    static void drive(Vunit& top, const int64_t* in) {
        constexpr int kN = DISPLACED_NORMAL_WIDTH;
        constexpr int kMap = MAP_NORMAL_WIDTH;
        constexpr int kBase = NORMAL_WIDTH;
        top.skip = bits<1>(in[0]);
        top.displaced_normal1_x = bits<kN>(in[1]);
        top.displaced_normal1_y = bits<kN>(in[2]);
        top.displaced_normal1_z = bits<kN>(in[3]);
        top.map_normal1_x = bits<kMap>(in[4]);
        top.map_normal1_y = bits<kMap>(in[5]);
        top.map_normal1_z = bits<kMap>(in[6]);
        top.normal1_x = bits<kBase>(in[7]);
        top.normal1_y = bits<kBase>(in[8]);
        top.normal1_z = bits<kBase>(in[9]);
        top.displaced_normal2_x = bits<kN>(in[10]);
        top.displaced_normal2_y = bits<kN>(in[11]);
        top.displaced_normal2_z = bits<kN>(in[12]);
        top.map_normal2_x = bits<kMap>(in[13]);
        top.map_normal2_y = bits<kMap>(in[14]);
        top.map_normal2_z = bits<kMap>(in[15]);
        top.normal2_x = bits<kBase>(in[16]);
        top.normal2_y = bits<kBase>(in[17]);
        top.normal2_z = bits<kBase>(in[18]);
        top.displaced_normal12_x = bits<kN>(in[19]);
        top.displaced_normal12_y = bits<kN>(in[20]);
        top.displaced_normal12_z = bits<kN>(in[21]);
        top.map_normal12_x = bits<kMap>(in[22]);
        top.map_normal12_y = bits<kMap>(in[23]);
        top.map_normal12_z = bits<kMap>(in[24]);
        top.normal12_x = bits<kBase>(in[25]);
        top.normal12_y = bits<kBase>(in[26]);
        top.normal12_z = bits<kBase>(in[27]);
    }

    static void sample(const Vunit& top, int64_t* out) { out[0] = top.nt; }
};

}  // namespace
}  // namespace repousse::harness

const RepousseEngine* repousse_engine() {
    return repousse::harness::engine<repousse::harness::NormalTestUnit>();
}
