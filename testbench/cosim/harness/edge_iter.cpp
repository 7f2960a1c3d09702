// The engine of rtl/units/edge_iter.sv.
#include "testbench/cosim/harness/harness.h"

namespace repousse::harness {
namespace {

struct EdgeIterUnit {
    static constexpr const char* kName = "edge_iter";
    static constexpr int kConfigs = 1;
    static constexpr int kInputs = 4;
    static constexpr int kOutputs = 3;
    static constexpr int kLast = 2;
    static constexpr int kReadEntries = 0;

    static void configure(Vunit& top, const int64_t* config) { top.cap = bits<4>(config[0]); }

    static void drive(Vunit& top, const int64_t* in) {
        top.generation1 = bits<4>(in[0]);
        top.generation2 = bits<4>(in[1]);
        top.generation3 = bits<4>(in[2]);
        top.unsplit = bits<3>(in[3]);
    }

    static void sample(const Vunit& top, int64_t* out) {
        out[0] = top.number;
        out[1] = top.eligible;
        out[2] = top.last;
    }
};

}  // namespace
}  // namespace repousse::harness

const RepousseEngine* repousse_engine() {
    return repousse::harness::engine<repousse::harness::EdgeIterUnit>();
}
