// The engine of rtl/units/sweep_line.sv.
#include "testbench/cosim/harness/sweep_line_inputs.h"

namespace repousse::harness {
namespace {

struct SweepLineUnit {
    static constexpr const char* kName = "sweep_line";
    static constexpr int C = COMPONENTS;
    static constexpr int kData = kSweepLineData;
    static constexpr int kConfigs = 1;
    static constexpr int kInputs = kSweepLineInputs;
    static constexpr int kOutputs = 4 * (C + 4) + 10;
    static constexpr int kReadEntries = 0;
    static constexpr int kLast = kOutputs - 1;

    static void configure(Vunit& top, const int64_t* config) { top.abort_all = bits<1>(config[0]); }

    static void drive(Vunit& top, const int64_t* in) { drive_sweep_line(top, in); }

    /// Of the vertices, only those that the beat has mean anything.
    static void sample(const Vunit& top, int64_t* out) {
        for (int i = 0; i < 4 * (C + 4); ++i) out[i] = 0;
        const auto vertex = [&](int k, const auto& data, int kind, int part, auto a, auto b) {
            if (k >= top.vertex_count) return;
            int64_t* to = out + (3 - k) * (C + 4);
            sample_vector<kData, true>(data, to, C);
            to[C] = kind;
            to[C + 1] = part;
            to[C + 2] = extended<14>(a);
            to[C + 3] = extended<14>(b);
        };
        vertex(0, top.data0, top.kind0, top.part0, top.a0, top.b0);
        vertex(1, top.data1, top.kind1, top.part1, top.a1, top.b1);
        vertex(2, top.data2, top.kind2, top.part2, top.a2, top.b2);
        vertex(3, top.data3, top.kind3, top.part3, top.a3, top.b3);
        out += 4 * (C + 4);
        const int64_t rest[] = {top.command3, top.command2,     top.command1, top.command0,
                                top.count,    top.vertex_count, top.init,     top.flip,
                                top.runaway,  top.last};
        for (const int64_t word : rest) *out++ = word;
    }
};

}  // namespace
}  // namespace repousse::harness

const RepousseEngine* repousse_engine() {
    return repousse::harness::engine<repousse::harness::SweepLineUnit>();
}
