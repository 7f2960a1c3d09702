#include "tlm/config/device_config.h"

namespace repousse {
namespace {

struct Choice {
    std::string_view unit;
    bool built;
};

std::vector<std::string_view> units_where(const DeviceConfig& c, bool built) {
    const Choice choices[] = {
        {"controller", c.has_controller()},
        {"triangle_stack", c.adaptive},
        {"edge_iter", c.adaptive},
        {"mid_vertex", c.adaptive},
        {"texcoord_test", c.adaptive},
        {"view_test", c.adaptive && c.view_test},
        {"normal_test", c.adaptive && c.normal_test},
        {"height_test", c.adaptive && c.height_test},
        {"split", c.adaptive},
        {"vertex_transform", c.has_vertex_transform()},
        {"grid_transform", c.sweep},
        {"view_clip", c.sweep && c.view_clip},
        {"triangle_setup", c.sweep},
        {"sweep_line", c.sweep},
        {"perspective", c.sweep},
        {"normalise", c.sweep},
        {"footprint", c.sweep && c.levels},
        {"bump", c.has_bump()},
        {"displace", c.has_displace()},
        {"strip", c.sweep},
        {"triangle_buffer", c.has_controller()},
    };
    std::vector<std::string_view> units;
    for (const Choice& choice : choices) {
        if (choice.built == built) units.push_back(choice.unit);
    }
    return units;
}

}  // namespace

std::vector<std::string_view> elaborated_units(const DeviceConfig& config) {
    return units_where(config, true);
}

std::vector<std::string_view> omitted_units(const DeviceConfig& config) {
    return units_where(config, false);
}

}  // namespace repousse
