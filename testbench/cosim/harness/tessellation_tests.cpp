// The engine of rtl/tops/tessellation_tests.sv.
#include "testbench/cosim/harness/sat_port.h"

namespace repousse::harness {
namespace {

struct TessellationTestsUnit : SatPort {
    static constexpr const char* kName = "tessellation_tests";
    static constexpr int kConfigs = 13;
    static constexpr int kInputs = 40;
    static constexpr int kOutputs = 5;

    static void configure(Vunit& top, const int64_t* config) {
        top.eager = bits<1>(config[0]);
        top.use_view_test = bits<1>(config[1]);
        top.use_normal_test = bits<1>(config[2]);
        top.use_height_test = bits<1>(config[3]);
        top.view_threshold = bits<SCREEN_WIDTH + 1>(config[4]);
        top.normal_threshold = bits<DISPLACED_NORMAL_WIDTH>(config[5]);
        top.map_space = bits<1>(config[6]);
        top.map_width = bits<13>(config[7]);
        top.map_height = bits<13>(config[8]);
        top.wrap = bits<1>(config[9]);
        top.literal = bits<1>(config[10]);
        top.sum = bits<1>(config[11]);
        top.height_threshold = bits<SAT_WIDTH>(config[12]);
    }

    static void drive(Vunit& top, const int64_t* in) {
        constexpr int kN = DISPLACED_NORMAL_WIDTH;
        constexpr int kMap = MAP_NORMAL_WIDTH;
        constexpr int kBase = NORMAL_WIDTH;
        top.eligible = bits<1>(in[0]);
        top.u1_x = bits<UV_WIDTH>(in[1]);
        top.u1_y = bits<UV_WIDTH>(in[2]);
        top.u2_x = bits<UV_WIDTH>(in[3]);
        top.u2_y = bits<UV_WIDTH>(in[4]);
        top.u12_x = bits<UV_WIDTH>(in[5]);
        top.u12_y = bits<UV_WIDTH>(in[6]);
        top.near1 = bits<1>(in[7]);
        top.x1 = bits<SCREEN_WIDTH>(in[8]);
        top.y1 = bits<SCREEN_WIDTH>(in[9]);
        top.near2 = bits<1>(in[10]);
        top.x2 = bits<SCREEN_WIDTH>(in[11]);
        top.y2 = bits<SCREEN_WIDTH>(in[12]);
        top.displaced_normal1_x = bits<kN>(in[13]);
        top.displaced_normal1_y = bits<kN>(in[14]);
        top.displaced_normal1_z = bits<kN>(in[15]);
        top.map_normal1_x = bits<kMap>(in[16]);
        top.map_normal1_y = bits<kMap>(in[17]);
        top.map_normal1_z = bits<kMap>(in[18]);
        top.normal1_x = bits<kBase>(in[19]);
        top.normal1_y = bits<kBase>(in[20]);
        top.normal1_z = bits<kBase>(in[21]);
        top.displaced_normal2_x = bits<kN>(in[22]);
        top.displaced_normal2_y = bits<kN>(in[23]);
        top.displaced_normal2_z = bits<kN>(in[24]);
        top.map_normal2_x = bits<kMap>(in[25]);
        top.map_normal2_y = bits<kMap>(in[26]);
        top.map_normal2_z = bits<kMap>(in[27]);
        top.normal2_x = bits<kBase>(in[28]);
        top.normal2_y = bits<kBase>(in[29]);
        top.normal2_z = bits<kBase>(in[30]);
        top.displaced_normal12_x = bits<kN>(in[31]);
        top.displaced_normal12_y = bits<kN>(in[32]);
        top.displaced_normal12_z = bits<kN>(in[33]);
        top.map_normal12_x = bits<kMap>(in[34]);
        top.map_normal12_y = bits<kMap>(in[35]);
        top.map_normal12_z = bits<kMap>(in[36]);
        top.normal12_x = bits<kBase>(in[37]);
        top.normal12_y = bits<kBase>(in[38]);
        top.normal12_z = bits<kBase>(in[39]);
    }

    static void sample(const Vunit& top, int64_t* out) {
        out[0] = top.split;
        out[1] = top.ct;
        out[2] = top.vt;
        out[3] = top.nt;
        out[4] = top.sht;
    }
};

}  // namespace
}  // namespace repousse::harness

const RepousseEngine* repousse_engine() {
    return repousse::harness::engine<repousse::harness::TessellationTestsUnit>();
}
