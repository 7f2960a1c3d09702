// The engine of rtl/units/view_test.sv.
#include "testbench/cosim/harness/harness.h"

namespace repousse::harness {
namespace {

struct ViewTestUnit {
    static constexpr const char* kName = "view_test";
    static constexpr int kConfigs = 1;
    static constexpr int kInputs = 7;
    static constexpr int kOutputs = 1;
    static constexpr int kReadEntries = 0;

    static void configure(Vunit& top, const int64_t* config) {
        top.threshold = bits<SCREEN_WIDTH + 1>(config[0]);
    }

    static void drive(Vunit& top, const int64_t* in) {
        top.skip = bits<1>(in[0]);
        top.near1 = bits<1>(in[1]);
        top.x1 = bits<SCREEN_WIDTH>(in[2]);
        top.y1 = bits<SCREEN_WIDTH>(in[3]);
        top.near2 = bits<1>(in[4]);
        top.x2 = bits<SCREEN_WIDTH>(in[5]);
        top.y2 = bits<SCREEN_WIDTH>(in[6]);
    }

    static void sample(const Vunit& top, int64_t* out) { out[0] = top.vt; }
};

}  // namespace
}  // namespace repousse::harness

const RepousseEngine* repousse_engine() {
    return repousse::harness::engine<repousse::harness::ViewTestUnit>();
}
