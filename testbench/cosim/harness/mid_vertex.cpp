// The engine of rtl/units/mid_vertex.sv.
#include "testbench/cosim/harness/harness.h"

namespace repousse::harness {
namespace {

struct MidVertexUnit {
    static constexpr const char* kName = "mid_vertex";
    static constexpr int kConfigs = 0;
    static constexpr int kInputs = 26;
    static constexpr int kOutputs = 13;
    static constexpr int kReadEntries = 0;

    static void configure(Vunit&, const int64_t*) {}

    static void drive(Vunit& top, const int64_t* in) {
        constexpr int kU = UV_WIDTH, kP = POSITION_WIDTH, kN = NORMAL_WIDTH;
        top.u1_x = bits<kU>(in[0]);
        top.u1_y = bits<kU>(in[1]);
        top.generation1 = bits<4>(in[2]);
        top.p1_x = bits<kP>(in[3]);
        top.p1_y = bits<kP>(in[4]);
        top.p1_z = bits<kP>(in[5]);
        top.n1_x = bits<kN>(in[6]);
        top.n1_y = bits<kN>(in[7]);
        top.n1_z = bits<kN>(in[8]);
        top.t1_x = bits<kN>(in[9]);
        top.t1_y = bits<kN>(in[10]);
        top.t1_z = bits<kN>(in[11]);
        top.left1 = bits<1>(in[12]);
        top.u2_x = bits<kU>(in[13]);
        top.u2_y = bits<kU>(in[14]);
        top.generation2 = bits<4>(in[15]);
        top.p2_x = bits<kP>(in[16]);
        top.p2_y = bits<kP>(in[17]);
        top.p2_z = bits<kP>(in[18]);
        top.n2_x = bits<kN>(in[19]);
        top.n2_y = bits<kN>(in[20]);
        top.n2_z = bits<kN>(in[21]);
        top.t2_x = bits<kN>(in[22]);
        top.t2_y = bits<kN>(in[23]);
        top.t2_z = bits<kN>(in[24]);
        top.left2 = bits<1>(in[25]);
    }

    static void sample(const Vunit& top, int64_t* out) {
        out[0] = extended<UV_WIDTH>(top.u12_x);
        out[1] = extended<UV_WIDTH>(top.u12_y);
        out[2] = top.generation12;
        out[3] = extended<POSITION_WIDTH>(top.p12_x);
        out[4] = extended<POSITION_WIDTH>(top.p12_y);
        out[5] = extended<POSITION_WIDTH>(top.p12_z);
        out[6] = extended<NORMAL_WIDTH>(top.n12_x);
        out[7] = extended<NORMAL_WIDTH>(top.n12_y);
        out[8] = extended<NORMAL_WIDTH>(top.n12_z);
        out[9] = extended<NORMAL_WIDTH>(top.t12_x);
        out[10] = extended<NORMAL_WIDTH>(top.t12_y);
        out[11] = extended<NORMAL_WIDTH>(top.t12_z);
        out[12] = top.left12;
    }
};

}  // namespace
}  // namespace repousse::harness

const RepousseEngine* repousse_engine() {
    return repousse::harness::engine<repousse::harness::MidVertexUnit>();
}
