// The engine of rtl/tops/sweep_chain.sv.
#include "testbench/cosim/harness/sweep_line_inputs.h"

namespace repousse::harness {
namespace {

/// The fields of a vertex port, the first one in the high bits.
struct Field {
    int width;
    bool is_signed;
};
constexpr Field kFields[] = {{POSITION_WIDTH, true},
                             {POSITION_WIDTH, true},
                             {POSITION_WIDTH, true},
                             {UNNORMALISED_WIDTH, true},
                             {UNNORMALISED_WIDTH, true},
                             {UNNORMALISED_WIDTH, true},
                             {UV_WIDTH, true},
                             {UV_WIDTH, true},
                             {UNNORMALISED_WIDTH, true},
                             {UNNORMALISED_WIDTH, true},
                             {UNNORMALISED_WIDTH, true},
                             {1, false},
                             {1, false}};
constexpr int kVertexFields = 13;
constexpr int kVertexWidth = 3 * POSITION_WIDTH + 6 * UNNORMALISED_WIDTH + 2 * UV_WIDTH + 2;

/// Reads a vertex port into words.
template <class Vector>
void sample_vertex(const Vector& port, int64_t* words) {
    int at = kVertexWidth;
    for (const Field& field : kFields) {
        at -= field.width;
        uint64_t bits = port[at / 32] >> at % 32;
        if (at % 32 + field.width > 32) {
            bits |= static_cast<uint64_t>(port[at / 32 + 1]) << (32 - at % 32);
        }
        const int spare = 64 - field.width;
        *words++ = field.is_signed ? static_cast<int64_t>(bits << spare) >> spare
                                   : static_cast<int64_t>(bits << spare >> spare);
    }
}

struct SweepChainUnit {
    static constexpr const char* kName = "sweep_chain";
    static constexpr int kConfigs = 2;
    static constexpr int kInputs = kSweepLineInputs;
    static constexpr int kOutputs = 6 * kVertexFields + 4;
    static constexpr int kReadEntries = 0;
    static constexpr int kLast = kOutputs - 1;

    static void configure(Vunit& top, const int64_t* config) {
        top.abort_all = bits<1>(config[0]);
        top.tangents = bits<1>(config[1]);
    }

    static void drive(Vunit& top, const int64_t* in) { drive_sweep_line(top, in); }

    /// Triangles that were not made are undefined on the ports, and 0 in a transaction.
    static void sample(const Vunit& top, int64_t* out) {
        for (int i = 0; i < kOutputs; ++i) out[i] = 0;
        if (top.triangles > 1) {
            sample_vertex(top.a1, out);
            sample_vertex(top.b1, out + kVertexFields);
            sample_vertex(top.c1, out + 2 * kVertexFields);
        }
        if (top.triangles > 0) {
            sample_vertex(top.a0, out + 3 * kVertexFields);
            sample_vertex(top.b0, out + 4 * kVertexFields);
            sample_vertex(top.c0, out + 5 * kVertexFields);
        }
        out[kOutputs - 4] = top.triangles;
        out[kOutputs - 3] = top.bad_ref;
        out[kOutputs - 2] = top.runaway;
        out[kOutputs - 1] = top.last;
    }
};

}  // namespace
}  // namespace repousse::harness

const RepousseEngine* repousse_engine() {
    return repousse::harness::engine<repousse::harness::SweepChainUnit>();
}
