#include "datapath/pipelines/sweep_counters.h"

#include <initializer_list>
#include <utility>

namespace repousse {
namespace {

class Rows {
public:
    void add(std::string_view unit,
             std::initializer_list<std::pair<std::string_view, uint64_t>> counters) {
        for (const auto& [name, value] : counters) rows_.push_back({unit, name, value});
    }
    std::vector<CounterRow> take() { return std::move(rows_); }

private:
    std::vector<CounterRow> rows_;
};

}  // namespace

std::vector<CounterRow> SweepCounters::rows() const {
    Rows rows;
    rows.add("controller", {{"items", controller.items},
                            {"displaced", controller.displaced},
                            {"direct", controller.direct},
                            {"overflows", controller.overflows}});
    rows.add("vertex_transform", {{"items", vertex_transform.items},
                                  {"overflows", vertex_transform.overflows},
                                  {"behind", vertex_transform.behind}});
    rows.add("grid_transform", {{"items", grid_transform.items},
                                {"w_clamped", grid_transform.w_clamped},
                                {"ratio_saturated", grid_transform.ratio_saturated},
                                {"grid_saturated", grid_transform.grid_saturated},
                                {"c_saturated", grid_transform.c_saturated},
                                {"data_saturated", grid_transform.data_saturated}});
    if (view_clip) {
        rows.add("view_clip", {{"items", view_clip->items}, {"rejected", view_clip->rejected}});
    }
    const TriangleSetupCounters& setup = triangle_setup;
    rows.add("triangle_setup", {{"items", setup.items},
                                {"clamped", setup.clamped},
                                {"single", setup.single},
                                {"collinear", setup.collinear},
                                {"roof", setup.forms[0]},
                                {"increasing", setup.forms[1]},
                                {"decreasing", setup.forms[2]},
                                {"divisions", setup.divisions}});
    const SweepLineCounters& sweep = sweep_line;
    rows.add("sweep_line", {{"items", sweep.items},
                            {"columns", sweep.columns},
                            {"steps", sweep.steps},
                            {"quads", sweep.quads},
                            {"ears", sweep.ears},
                            {"triangles", sweep.triangles},
                            {"additions", sweep.additions},
                            {"commands", sweep.commands},
                            {"swaps", sweep.swaps},
                            {"vertices", sweep.vertices},
                            {"displaced", sweep.displaced},
                            {"kept", sweep.kept},
                            {"runaways", sweep.runaways}});
    rows.add("perspective", {{"items", perspective.items},
                             {"overflows", perspective.overflows},
                             {"clamped", perspective.clamped}});
    rows.add("normalise", {{"items", normalise.items}, {"degenerate", normalise.degenerate}});
    if (footprint) {
        constexpr std::string_view kLevels[] = {"level_0",  "level_1",  "level_2",  "level_3",
                                                "level_4",  "level_5",  "level_6",  "level_7",
                                                "level_8",  "level_9",  "level_10", "level_11",
                                                "level_12", "level_13", "level_14"};
        rows.add("footprint", {{"items", footprint->items}});
        for (std::size_t l = 0; l < footprint->levels.size(); ++l) {
            rows.add("footprint", {{kLevels[l], footprint->levels[l]}});
        }
        rows.add("footprint", {{"back", footprint->back}, {"cut", footprint->cut}});
    }
    rows.add(
        "displace",
        {{"items", displace.items}, {"reads", displace.reads}, {"overflows", displace.overflows}});
    if (bump) {
        rows.add("bump", {{"items", bump->items},
                          {"reads", bump->reads},
                          {"overflows", bump->overflows},
                          {"degenerate", bump->degenerate},
                          {"degenerate_frames", bump->degenerate_frames}});
    }
    if (shade) {
        rows.add("shade", {{"items", shade->items},
                           {"saturated", shade->saturated},
                           {"degenerate", shade->degenerate}});
    }
    rows.add("strip", {{"steps", strip.steps},
                       {"commands", strip.commands},
                       {"strips", strip.strips},
                       {"swaps", strip.swaps},
                       {"vertices", strip.vertices},
                       {"triangles", strip.triangles},
                       {"bad_refs", strip.bad_refs}});
    const TriangleBufferCounters& buffer = triangle_buffer;
    rows.add("triangle_buffer", {{"items", buffer.items},
                                 {"triangles", buffer.triangles},
                                 {"direct", buffer.direct},
                                 {"empty", buffer.empty},
                                 {"switches", buffer.switches}});
    return rows.take();
}

}  // namespace repousse
