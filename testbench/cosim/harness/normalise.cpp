// The engine of rtl/units/normalise.sv.
#include "testbench/cosim/harness/harness.h"

namespace repousse::harness {
namespace {

struct NormaliseUnit {
    static constexpr const char* kName = "normalise";
    static constexpr int kConfigs = 0;
    static constexpr int kInputs = 3;
    static constexpr int kOutputs = 3;
    static constexpr int kReadEntries = 0;

    static void configure(Vunit&, const int64_t*) {}

    static void drive(Vunit& top, const int64_t* in) {
        top.x = bits<UNNORMALISED_WIDTH>(in[0]);
        top.y = bits<UNNORMALISED_WIDTH>(in[1]);
        top.z = bits<UNNORMALISED_WIDTH>(in[2]);
    }

    static void sample(const Vunit& top, int64_t* out) {
        out[0] = extended<NORMAL_WIDTH>(top.unit_x);
        out[1] = extended<NORMAL_WIDTH>(top.unit_y);
        out[2] = extended<NORMAL_WIDTH>(top.unit_z);
    }
};

}  // namespace
}  // namespace repousse::harness

const RepousseEngine* repousse_engine() {
    return repousse::harness::engine<repousse::harness::NormaliseUnit>();
}
