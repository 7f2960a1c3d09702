// Why the scene needs each unit, or does without.

#include "testbench/app/job.h"

namespace repousse::app {

std::vector<UnitReason> explain_units(const Job& job) {
    const DeviceConfig& need = job.needed;
    const DeviceConfig& built = job.device;
    const auto reason = [](std::string_view unit, bool is_built, bool is_needed,
                           std::string_view yes, std::string_view no) {
        std::string why(is_needed ? yes : no);
        if (is_built && !is_needed) why += "; built on request";
        return UnitReason{unit, is_built, why};
    };
    const auto adaptive = [&](std::string_view unit, std::string_view why) {
        return reason(unit, built.adaptive, need.adaptive, why, "no object is adaptive");
    };
    const auto sweep = [&](std::string_view unit, std::string_view why) {
        return reason(unit, built.sweep, need.sweep, why, "no object is remeshed by sweep lines");
    };
    return {
        reason("controller", built.has_controller(), need.has_controller(),
               "base triangles are sent on, displaced or as they are", "every object is adaptive"),
        adaptive("triangle_stack", "every adaptive object is tessellated recursively"),
        adaptive("edge_iter", "tests are made edge by edge"),
        adaptive("mid_vertex", "new vertices are midpoints of edges"),
        adaptive("texcoord_test", "refinement ends at the map's resolution"),
        reason("view_test", built.adaptive && built.view_test, need.view_test,
               "an object has view_threshold_px", "no object has view_threshold_px"),
        reason("normal_test", built.adaptive && built.normal_test, need.normal_test,
               "an object has normal_threshold", "no object has normal_threshold"),
        reason("height_test", built.adaptive && built.height_test, need.height_test,
               "an object has a height threshold",
               "no object has a height threshold: no summed-area table is made"),
        adaptive("split", "edges are decided and triangles cut"),
        reason("vertex_transform", built.has_vertex_transform(), need.has_vertex_transform(),
               need.sweep ? "base vertices are brought to the eye"
                          : "the view test measures on the screen",
               "without a view test or a sweep no screen position is needed"),
        sweep("grid_transform", "base vertices are brought to the grid"),
        reason("view_clip", built.sweep && built.view_clip, need.view_clip,
               "base triangles outside the view are rejected", "no object has sweep.clip"),
        sweep("triangle_setup", "differences along edges and in the plane are computed once"),
        sweep("sweep_line", "triangles are cut into pieces of one grid unit"),
        sweep("perspective", "what was interpolated on the grid is divided by 1/w"),
        sweep("normalise", "interpolated normals are brought to unit length"),
        reason("footprint", built.sweep && built.levels, need.sweep && need.levels,
               "an object has filter levels: what a vertex reads depends on its distance",
               "no object has filter levels (map.levels)"),
        reason("bump", built.has_bump(), need.has_bump(),
               need.normal_test ? "the normal test compares displaced normals"
                                : "an object asks for displaced normals with [object.bump]",
               "no object has normal_threshold or [object.bump]: no normal map is made"),
        reason("displace", built.has_displace(), need.has_displace(), "vertices are displaced",
               "no object is displaced"),
        reason("shade", built.has_displace() && built.shade, need.has_displace() && need.shade,
               "an object is coloured by the scene's lights with [object.shade]",
               "no object has [object.shade]"),
        sweep("strip", "vertices become triangles"),
        reason("triangle_buffer", built.has_controller(), need.has_controller(),
               "triangles leave in the order of their base triangles", "every object is adaptive"),
    };
}

}  // namespace repousse::app
