// The engine of rtl/units/texel_cache.sv.
#include "testbench/cosim/harness/harness.h"

namespace repousse::harness {
namespace {

struct TexelCacheUnit {
    static constexpr const char* kName = "texel_cache";
    static constexpr int kConfigs = 0;
    static constexpr int kInputs = 2;
    static constexpr int kOutputs = 4;
    static constexpr int kReadEntries = 1;

    static void configure(Vunit&, const int64_t*) {}

    static void drive(Vunit& top, const int64_t* in) {
        top.invalidate = bits<1>(in[0]);
        top.address = bits<30>(in[1]);
    }

    static void sample(const Vunit& top, int64_t* out) {
        out[0] = static_cast<int64_t>(top.data);
        out[1] = top.hit;
        out[2] = top.way;
        out[3] = top.evicted;
    }

    static void drive_memory(Vunit& top, bool ready, bool rvalid, const uint64_t* rdata) {
        top.word_ready = ready;
        top.word_rvalid = rvalid;
        if (rvalid) top.word_rdata = bits<HEIGHT_WIDTH>(static_cast<int64_t>(rdata[0]));
    }

    static bool requests(const Vunit& top) { return top.word_valid; }
    static bool takes_answer(const Vunit& top) { return top.word_rready; }
    static bool wants(const Vunit&, int) { return true; }

    // A table of 64 x 64 entries behind 2^30 addresses: folded, so that every bit of an address
    // makes a difference to what is read.
    static Address address(const Vunit& top, int) {
        const uint32_t folded = top.word_address ^ top.word_address >> 12 ^ top.word_address >> 24;
        return {folded & 63, folded >> 6 & 63};
    }
};

}  // namespace
}  // namespace repousse::harness

const RepousseEngine* repousse_engine() {
    return repousse::harness::engine<repousse::harness::TexelCacheUnit>();
}
