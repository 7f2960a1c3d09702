// The engine of rtl/units/shade.sv.
#include "testbench/cosim/harness/harness.h"

namespace repousse::harness {
namespace {

struct ShadeUnit {
    static constexpr const char* kName = "shade";
    static constexpr int kConfigs = 8 + 9 * LIGHTS;
    static constexpr int kInputs = 6;
    static constexpr int kOutputs = 3;
    static constexpr int kReadEntries = 0;

    static void configure(Vunit& top, const int64_t* config) {
        top.eye_x = bits<POSITION_WIDTH>(config[0]);
        top.eye_y = bits<POSITION_WIDTH>(config[1]);
        top.eye_z = bits<POSITION_WIDTH>(config[2]);
        top.ambient_red = bits<LIGHT_WIDTH>(config[3]);
        top.ambient_green = bits<LIGHT_WIDTH>(config[4]);
        top.ambient_blue = bits<LIGHT_WIDTH>(config[5]);
        top.shininess = bits<8>(config[6]);
        top.two_sided = bits<1>(config[7]);
        const int64_t* lights = config + 8;
        drive_vector<NORMAL_WIDTH>(top.light_x, lights, LIGHTS);
        drive_vector<NORMAL_WIDTH>(top.light_y, lights + LIGHTS, LIGHTS);
        drive_vector<NORMAL_WIDTH>(top.light_z, lights + 2 * LIGHTS, LIGHTS);
        drive_vector<LIGHT_WIDTH>(top.diffuse_red, lights + 3 * LIGHTS, LIGHTS);
        drive_vector<LIGHT_WIDTH>(top.diffuse_green, lights + 4 * LIGHTS, LIGHTS);
        drive_vector<LIGHT_WIDTH>(top.diffuse_blue, lights + 5 * LIGHTS, LIGHTS);
        drive_vector<LIGHT_WIDTH>(top.specular_red, lights + 6 * LIGHTS, LIGHTS);
        drive_vector<LIGHT_WIDTH>(top.specular_green, lights + 7 * LIGHTS, LIGHTS);
        drive_vector<LIGHT_WIDTH>(top.specular_blue, lights + 8 * LIGHTS, LIGHTS);
    }

    static void drive(Vunit& top, const int64_t* in) {
        top.p_x = bits<POSITION_WIDTH>(in[0]);
        top.p_y = bits<POSITION_WIDTH>(in[1]);
        top.p_z = bits<POSITION_WIDTH>(in[2]);
        top.n_x = bits<NORMAL_WIDTH>(in[3]);
        top.n_y = bits<NORMAL_WIDTH>(in[4]);
        top.n_z = bits<NORMAL_WIDTH>(in[5]);
    }

    static void sample(const Vunit& top, int64_t* out) {
        out[0] = top.red;
        out[1] = top.green;
        out[2] = top.blue;
    }
};

}  // namespace
}  // namespace repousse::harness

const RepousseEngine* repousse_engine() {
    return repousse::harness::engine<repousse::harness::ShadeUnit>();
}
