// The engine of rtl/units/strip.sv. Vertices are numbers here.
#include "testbench/cosim/harness/harness.h"

namespace repousse::harness {
namespace {

struct StripUnit {
    static constexpr const char* kName = "strip";
    static constexpr int kConfigs = 0;
    static constexpr int kInputs = 12;
    static constexpr int kOutputs = 8;
    static constexpr int kReadEntries = 0;

    static void configure(Vunit&, const int64_t*) {}

    static void drive(Vunit& top, const int64_t* in) {
        top.flush = bits<1>(in[0]);
        top.init = bits<1>(in[1]);
        top.flip = bits<1>(in[2]);
        top.count = bits<3>(in[3]);
        top.command0 = bits<6>(in[4]);
        top.command1 = bits<6>(in[5]);
        top.command2 = bits<6>(in[6]);
        top.command3 = bits<6>(in[7]);
        top.vertex0 = bits<32>(in[8]);
        top.vertex1 = bits<32>(in[9]);
        top.vertex2 = bits<32>(in[10]);
        top.vertex3 = bits<32>(in[11]);
    }

    /// Triangles that were not made are undefined on the ports, and 0 in a transaction.
    static void sample(const Vunit& top, int64_t* out) {
        const bool first = top.triangles > 0, second = top.triangles > 1;
        out[0] = top.triangles;
        out[1] = top.bad_ref;
        out[2] = first ? top.a0 : 0;
        out[3] = first ? top.b0 : 0;
        out[4] = first ? top.c0 : 0;
        out[5] = second ? top.a1 : 0;
        out[6] = second ? top.b1 : 0;
        out[7] = second ? top.c1 : 0;
    }
};

}  // namespace
}  // namespace repousse::harness

const RepousseEngine* repousse_engine() {
    return repousse::harness::engine<repousse::harness::StripUnit>();
}
