#include "testbench/cosim/unit_model.h"

#include "testbench/cosim/parameters.h"

namespace repousse::cosim {

UnitModel::UnitModel(const Profile& profile, const UnitDesc& desc)
    : profile_(profile),
      inputs_(port_words(desc, PortKind::Input, profile).size()),
      outputs_(port_words(desc, PortKind::Output, profile).size()),
      last_(last_word(desc, profile)) {}

const std::vector<std::string_view>& rtl_units() {
    static const std::vector<std::string_view> names = {
        "texcoord_test", "view_test",   "normal_test", "edge_iter",   "mid_vertex",
        "split",         "displace",    "bump",        "height_test", "grid_transform",
        "view_clip",     "perspective", "strip",       "sweep_line",  "sweep_chain",
        "shade",         "normalise",   "footprint",   "texel_cache", "tessellation_tests"};
    return names;
}

std::unique_ptr<UnitModel> make_unit_model(std::string_view name, const Profile& profile) {
    if (name == "texcoord_test") return make_texcoord_test_model(profile);
    if (name == "view_test") return make_view_test_model(profile);
    if (name == "height_test") return make_height_test_model(profile);
    if (name == "normal_test") return make_normal_test_model(profile);
    if (name == "edge_iter") return make_edge_iter_model(profile);
    if (name == "split") return make_split_model(profile);
    if (name == "mid_vertex") return make_mid_vertex_model(profile);
    if (name == "displace") return make_displace_model(profile);
    if (name == "bump") return make_bump_model(profile);
    if (name == "view_clip") return make_view_clip_model(profile);
    if (name == "perspective") return make_perspective_model(profile);
    if (name == "grid_transform") return make_grid_transform_model(profile);
    if (name == "strip") return make_strip_model(profile);
    if (name == "sweep_chain") return make_sweep_chain_model(profile);
    if (name == "sweep_line") return make_sweep_line_model(profile);
    if (name == "shade") return make_shade_model(profile);
    if (name == "footprint") return make_footprint_model(profile);
    if (name == "normalise") return make_normalise_model(profile);
    if (name == "texel_cache") return make_texel_cache_model(profile);
    if (name == "tessellation_tests") return make_tessellation_tests_model(profile);
    return nullptr;
}

}  // namespace repousse::cosim
