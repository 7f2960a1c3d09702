#include "datapath/pipelines/adaptive_counters.h"

#include <algorithm>

namespace repousse {
namespace {

void add_test(std::vector<CounterRow>& rows, std::string_view unit, const TestCounters& c) {
    rows.insert(
        rows.end(),
        {{unit, "items", c.items}, {unit, "tests", c.tests}, {unit, "positives", c.positives}});
}

}  // namespace

std::vector<CounterRow> AdaptiveCounters::rows() const {
    std::vector<CounterRow> rows = {
        {"triangle_stack", "peak", stack_peak},
        {"edge_iter", "items", edge_iter.items},
        {"edge_iter", "capped", edge_iter.capped},
        {"edge_iter", "known_unsplit", edge_iter.known_unsplit},
        {"mid_vertex", "items", mid_vertex.items},
        {"mid_vertex", "attributes", mid_vertex.attributes},
        {"mid_vertex", "overflows", mid_vertex.overflows},
        {"mid_vertex", "degenerate", mid_vertex.degenerate},
    };
    add_test(rows, "texcoord_test", texcoord_test);
    if (view_test) add_test(rows, "view_test", *view_test);
    if (bump) {
        rows.insert(rows.end(), {{"bump", "items", bump->items},
                                 {"bump", "reads", bump->reads},
                                 {"bump", "overflows", bump->overflows},
                                 {"bump", "degenerate", bump->degenerate},
                                 {"bump", "degenerate_frames", bump->degenerate_frames}});
    }
    if (normal_test) add_test(rows, "normal_test", *normal_test);
    if (height_test) {
        add_test(rows, "height_test", *height_test);
        rows.push_back({"height_test", "reads", height_test_reads});
    }
    rows.insert(rows.end(), {{"split", "items", split.items},
                             {"split", "pass", split.edges_split[0]},
                             {"split", "one_edge", split.edges_split[1]},
                             {"split", "two_edges", split.edges_split[2]},
                             {"split", "three_edges", split.edges_split[3]},
                             {"split", "overflows", split.overflows},
                             {"displace", "items", displace.items},
                             {"displace", "reads", displace.reads},
                             {"displace", "overflows", displace.overflows}});
    if (shade) {
        rows.insert(rows.end(), {{"shade", "items", shade->items},
                                 {"shade", "saturated", shade->saturated},
                                 {"shade", "degenerate", shade->degenerate}});
    }
    if (vertex_transform) {
        rows.insert(rows.end(), {{"vertex_transform", "items", vertex_transform->items},
                                 {"vertex_transform", "overflows", vertex_transform->overflows},
                                 {"vertex_transform", "behind", vertex_transform->behind}});
    }
    return rows;
}

void merge_rows(std::vector<CounterRow>& total, const std::vector<CounterRow>& rows) {
    for (const CounterRow& row : rows) {
        const auto same = [&row](const CounterRow& other) {
            return other.unit == row.unit && other.name == row.name;
        };
        const auto found = std::find_if(total.begin(), total.end(), same);
        if (found == total.end()) {
            total.push_back(row);
        } else if (row.name == "peak") {
            found->value = std::max(found->value, row.value);
        } else {
            found->value += row.value;
        }
    }
}

}  // namespace repousse
