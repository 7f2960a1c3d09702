// The engine of rtl/units/height_test.sv.
#include "testbench/cosim/harness/harness.h"

namespace repousse::harness {
namespace {

/// A port of up to 64 bits, or one that Verilator keeps as an array of 32-bit words.
template <class Port>
void assign(Port& port, unsigned __int128 value) {
    port = static_cast<Port>(value);
}
template <std::size_t words>
void assign(VlWide<words>& port, unsigned __int128 value) {
    for (std::size_t i = 0; i < words; ++i) port[i] = static_cast<EData>(value >> 32 * i);
}

struct HeightTestUnit {
    static constexpr const char* kName = "height_test";
    static constexpr int kConfigs = 6;
    static constexpr int kInputs = 7;
    static constexpr int kOutputs = 1;
    static constexpr int kReadEntries = 3;

    static void configure(Vunit& top, const int64_t* config) {
        top.map_width = bits<13>(config[0]);
        top.map_height = bits<13>(config[1]);
        top.wrap = bits<1>(config[2]);
        top.literal = bits<1>(config[3]);
        top.sum = bits<1>(config[4]);
        top.threshold = bits<SAT_WIDTH>(config[5]);
    }

    static void drive(Vunit& top, const int64_t* in) {
        top.skip = bits<1>(in[0]);
        top.u1_x = bits<UV_WIDTH>(in[1]);
        top.u1_y = bits<UV_WIDTH>(in[2]);
        top.u2_x = bits<UV_WIDTH>(in[3]);
        top.u2_y = bits<UV_WIDTH>(in[4]);
        top.u12_x = bits<UV_WIDTH>(in[5]);
        top.u12_y = bits<UV_WIDTH>(in[6]);
    }

    static void sample(const Vunit& top, int64_t* out) { out[0] = top.sht; }

    static void drive_memory(Vunit& top, bool ready, bool rvalid, const uint64_t* rdata) {
        top.sat_ready = ready;
        top.sat_rvalid = rvalid;
        if (!rvalid) return;
        static_assert(3 * SAT_WIDTH <= 128);
        const auto wide = [rdata](int entry) {
            return static_cast<unsigned __int128>(rdata[entry]) << (entry * SAT_WIDTH);
        };
        assign(top.sat_rdata, wide(0) | wide(1) | wide(2));
    }

    static bool requests(const Vunit& top) { return top.sat_valid; }
    static bool takes_answer(const Vunit& top) { return top.sat_rready; }
    static bool wants(const Vunit& top, int entry) { return top.sat_read >> entry & 1; }
    static Address address(const Vunit& top, int entry) {
        const int low = 13 * entry;
        return {static_cast<uint32_t>(top.sat_x >> low & 0x1fff),
                static_cast<uint32_t>(top.sat_y >> low & 0x1fff)};
    }
};

}  // namespace
}  // namespace repousse::harness

const RepousseEngine* repousse_engine() {
    return repousse::harness::engine<repousse::harness::HeightTestUnit>();
}
