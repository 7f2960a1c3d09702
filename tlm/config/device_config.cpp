#include "tlm/config/device_config.h"

namespace repousse {
namespace {

struct Choice {
    std::string_view unit;
    bool built;
};

std::vector<std::string_view> units_where(const DeviceConfig& c, bool built) {
    const Choice choices[] = {
        {"triangle_stack", true},
        {"edge_iter", true},
        {"mid_vertex", true},
        {"texcoord_test", true},
        {"view_test", c.view_test},
        {"bump", c.bump},
        {"normal_test", c.normal_test},
        {"height_test", c.height_test},
        {"split", true},
        {"displace", true},
        {"vertex_transform", c.view_test},
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
