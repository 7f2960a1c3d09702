// The engine of rtl/units/grid_transform.sv.
#include "testbench/cosim/harness/harness.h"

namespace repousse::harness {
namespace {

struct GridTransformUnit {
    static constexpr const char* kName = "grid_transform";
    static constexpr int kConfigs = 9;
    static constexpr int kInputs = 4;
    static constexpr int kOutputs = 5;
    static constexpr int kReadEntries = 0;

    static void configure(Vunit& top, const int64_t* config) {
        top.w_min = bits<CLIP_WIDTH>(config[0]);
        top.w_scale = bits<CLIP_WIDTH>(config[1]);
        top.focal_x = bits<FOCAL_WIDTH>(config[2]);
        top.focal_y = bits<FOCAL_WIDTH>(config[3]);
        top.steps_per_octave = bits<STEPS_PER_OCTAVE_WIDTH>(config[4]);
        top.log2_near = bits<27>(config[5]);
        top.table_near = bits<CLIP_WIDTH>(config[6]);
        top.table_scale = bits<20>(config[7]);
        top.table_shift = bits<6>(config[8]);
        top.table_write = 0;
    }

    /// Writes the uniform table, a word a cycle, while the unit is empty.
    static void load(Vunit& top, const RepousseTable& table) {
        top.in_valid = 0;
        top.table_write = 1;
        for (uint64_t i = 0; i < table.count; ++i) {
            top.table_address = bits<Z_TABLE_INDEX_BITS + 1>(static_cast<int64_t>(i));
            top.table_data = bits<22>(static_cast<int64_t>(table.entries[i]));
            top.clk = 0;
            top.eval();
            top.clk = 1;
            top.eval();
        }
        top.table_write = 0;
    }

    static void drive(Vunit& top, const int64_t* in) {
        top.x = bits<CLIP_WIDTH>(in[0]);
        top.y = bits<CLIP_WIDTH>(in[1]);
        top.w = bits<CLIP_WIDTH>(in[2]);
        top.attribute = bits<POSITION_WIDTH>(in[3]);
    }

    static void sample(const Vunit& top, int64_t* out) {
        out[0] = extended<22>(top.x_grid);
        out[1] = extended<22>(top.y_grid);
        out[2] = extended<22>(top.z_grid);
        out[3] = extended<INVERSE_W_WIDTH>(top.c);
        out[4] = extended<SWEEP_DATA_WIDTH>(top.data);
    }
};

}  // namespace
}  // namespace repousse::harness

const RepousseEngine* repousse_engine() {
    return repousse::harness::engine<repousse::harness::GridTransformUnit>();
}
