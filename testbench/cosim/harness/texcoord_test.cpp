// The engine of rtl/units/texcoord_test.sv.
#include "testbench/cosim/harness/harness.h"

namespace repousse::harness {
namespace {

struct TexcoordTestUnit {
    static constexpr const char* kName = "texcoord_test";
    static constexpr int kConfigs = 0;
    static constexpr int kInputs = 7;
    static constexpr int kOutputs = 1;
    static constexpr int kReadEntries = 0;

    static void configure(Vunit&, const int64_t*) {}

    static void drive(Vunit& top, const int64_t* in) {
        top.skip = bits<1>(in[0]);
        top.u1_x = bits<UV_WIDTH>(in[1]);
        top.u1_y = bits<UV_WIDTH>(in[2]);
        top.u2_x = bits<UV_WIDTH>(in[3]);
        top.u2_y = bits<UV_WIDTH>(in[4]);
        top.u12_x = bits<UV_WIDTH>(in[5]);
        top.u12_y = bits<UV_WIDTH>(in[6]);
    }

    static void sample(const Vunit& top, int64_t* out) { out[0] = top.ct; }
};

}  // namespace
}  // namespace repousse::harness

const RepousseEngine* repousse_engine() {
    return repousse::harness::engine<repousse::harness::TexcoordTestUnit>();
}
