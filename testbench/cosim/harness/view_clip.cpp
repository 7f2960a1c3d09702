// The engine of rtl/units/view_clip.sv.
#include "testbench/cosim/harness/harness.h"

namespace repousse::harness {
namespace {

struct ViewClipUnit {
    static constexpr const char* kName = "view_clip";
    static constexpr int kConfigs = 7;
    static constexpr int kInputs = 10;
    static constexpr int kOutputs = 2;
    static constexpr int kReadEntries = 0;

    static void configure(Vunit& top, const int64_t* config) {
        top.near_w = bits<CLIP_WIDTH>(config[0]);
        top.far_w = bits<CLIP_WIDTH>(config[1]);
        top.cosine_x = bits<VIEW_ROW_WIDTH>(config[2]);
        top.sine_x = bits<VIEW_ROW_WIDTH>(config[3]);
        top.cosine_y = bits<VIEW_ROW_WIDTH>(config[4]);
        top.sine_y = bits<VIEW_ROW_WIDTH>(config[5]);
        top.margin = bits<CLIP_WIDTH>(config[6]);
    }

    static void drive(Vunit& top, const int64_t* in) {
        top.x1 = bits<CLIP_WIDTH>(in[0]);
        top.y1 = bits<CLIP_WIDTH>(in[1]);
        top.w1 = bits<CLIP_WIDTH>(in[2]);
        top.x2 = bits<CLIP_WIDTH>(in[3]);
        top.y2 = bits<CLIP_WIDTH>(in[4]);
        top.w2 = bits<CLIP_WIDTH>(in[5]);
        top.x3 = bits<CLIP_WIDTH>(in[6]);
        top.y3 = bits<CLIP_WIDTH>(in[7]);
        top.w3 = bits<CLIP_WIDTH>(in[8]);
        top.max_displacement = bits<DISPLACEMENT_WIDTH>(in[9]);
    }

    static void sample(const Vunit& top, int64_t* out) {
        out[0] = top.reject;
        out[1] = top.outside;
    }
};

}  // namespace
}  // namespace repousse::harness

const RepousseEngine* repousse_engine() {
    return repousse::harness::engine<repousse::harness::ViewClipUnit>();
}
