#include "testbench/cosim/tessellation_tests_cases.h"

#include "testbench/cosim/edge_scenarios.h"
#include "testbench/cosim/height_test_cases.h"

namespace repousse::cosim {
namespace {

using Registers = EdgeScenarios::Registers;
using In = EdgeScenarios::In;

/// Each test with the others not used, on its threshold and one LSB beside it.
void each_alone(EdgeScenarios& cases, const Profile& profile) {
    const int32_t t = cases.texel();
    cases.begin("texcoord_alone", cases.only(false, false, false));
    for (const int32_t off : {-1, 0, 1}) {
        cases.edge(cases.between({0, 0}, {2 * t + off, 0}));
        cases.edge(cases.between({off, off}, {t, 4 * t}));
    }

    const In longest = cases.between({0, 0}, {4 * t, 2 * t});
    Registers r = cases.only(true, false, false);
    const auto threshold = static_cast<int32_t>(r.view_threshold);
    cases.begin("view_alone", r);
    for (int32_t d = threshold - 1; d <= threshold + 1; ++d) {
        In in = longest;
        in.p2 = {d / 3, d / 3 - d, false};
        cases.edge(in);
    }

    for (const NormalSpace space : {NormalSpace::World, NormalSpace::Map}) {
        r = cases.only(false, true, false);
        r.normal_space = space;
        cases.begin(space == NormalSpace::Map ? "normal_alone_map_space" : "normal_alone", r);
        for (int32_t d = r.normal_threshold - 1; d <= r.normal_threshold + 1; ++d) {
            In in = longest;
            in.vertices[0].displaced_normal.x = d;
            cases.edge(in);
            in = longest;
            in.vertices[2].map_normal.y = -static_cast<int32_t>(
                Fixed::align(d, profile.map_normal.frac - profile.displaced_normal.frac));
            cases.edge(in);
            in = longest;
            in.vertices[2].normal.z = static_cast<int32_t>(
                Fixed::align(d, profile.normal.frac - profile.displaced_normal.frac));
            cases.edge(in);
        }
    }

    r = cases.only(false, false, true);
    for (const HeightMode mode : {HeightMode::Average, HeightMode::Sum}) {
        r.height_test.mode = mode;
        HeightTest unit(profile);
        const uint64_t most = mode == HeightMode::Average
                                  ? static_cast<uint64_t>(cases.max_height())
                                  : (uint64_t{1} << profile.sat_width) - 1;
        const uint64_t border =
            border_threshold(unit, r.height_test, cases.map()->entries,
                             {false, longest.u1, longest.u2, longest.u12}, most);
        for (const uint64_t of_case : {border - (border > 0), border}) {
            r.height_test.threshold = of_case;
            cases.begin("height_alone", r);
            cases.edge(longest);
        }
    }
}

/// Every combination of what the four would say, of an edge that may be split and of one that may
/// not, for all tests, eager tests, and without each of them.
void every_result(EdgeScenarios& cases) {
    struct Use {
        const char* name;
        bool eager, view, normal, height;
    };
    for (const Use& use : {Use{"all_results", false, true, true, true},
                           Use{"all_results_eager", true, true, true, true},
                           Use{"without_view_test", false, false, true, true},
                           Use{"without_normal_test", false, true, false, true},
                           Use{"without_height_test", false, true, true, false},
                           Use{"without_surface_tests_eager", true, true, false, false}}) {
        Registers r = cases.only(use.view, use.normal, use.height);
        r.eager = use.eager;
        cases.begin(use.name, r);
        for (unsigned says = 0; says < 32; ++says) {
            const auto bit = [says](unsigned i) { return (says >> i & 1) != 0; };
            In in = cases.found(r, bit(1), bit(2));
            in.eligible = bit(0);
            in.p2.y = static_cast<int32_t>(r.view_threshold) + bit(3);
            in.vertices[2].displaced_normal.z = r.normal_threshold + bit(4);
            if (says % 2 == 0) std::swap(in.p1, in.p2);
            cases.edge(in);
        }
    }
}

/// Long on the screen, on the map, and bent: all tests find it.
In plain(const EdgeScenarios& cases, Uv u1, Uv u2) {
    In in = cases.between(u1, u2);
    in.p1.near = true;
    return in;
}

void seams(EdgeScenarios& cases) {
    const int32_t t = cases.texel();
    Registers r = cases.registers();
    r.height_test.wrap = true;
    for (const HeightMode mode : {HeightMode::Average, HeightMode::Sum}) {
        r.height_test.mode = mode;
        cases.begin("seam_in_x", r);  // 6 reads a box
        cases.edge(plain(cases, {7 * t, 4 * t}, {9 * t, 4 * t}));
        cases.edge(plain(cases, {-t, 4 * t}, {t, 5 * t}));
        cases.begin("seam_in_y", r);
        cases.edge(plain(cases, {4 * t, -t}, {5 * t, t}));
        cases.begin("seam_in_both", r);  // 9 reads a box
        cases.edge(plain(cases, {-t, -t}, {t, t}));
        cases.edge(plain(cases, {0, 0}, {8 * t, 8 * t}));
    }
}

void borders(EdgeScenarios& cases, const Profile& profile) {
    const int32_t t = cases.texel();
    const auto most = static_cast<int32_t>(profile.screen.max_raw());
    const auto least = static_cast<int32_t>(profile.screen.min_raw());
    cases.begin("near_plane", cases.registers());  // of ends that mean nothing
    for (const bool near1 : {false, true}) {
        for (const bool near2 : {false, true}) {
            In in = cases.between({0, 0}, {6 * t, 2 * t});
            in.p1.near = near1, in.p2.near = near2;
            cases.edge(in);
            in.p1.x = least, in.p2.x = most;
            cases.edge(in);
        }
    }

    Registers r = cases.registers();
    for (const bool eager : {false, true}) {
        r.eager = eager;
        cases.begin(eager ? "zero_length_eager" : "zero_length", r);
        for (const int32_t x : {-1, 0, t, 4 * t - 1, 8 * t})
            cases.edge(plain(cases, {x, x}, {x, x}));
        cases.begin(eager ? "none_eligible_eager" : "none_eligible", r);
        for (int32_t x = 0; x < 4; ++x) {
            In in = plain(cases, {x * t, 0}, {8 * t, 8 * t});
            in.eligible = false;
            cases.edge(in);
        }
    }

    r = cases.registers();
    r.view_threshold = 0, r.normal_threshold = 0, r.height_test.threshold = 0;
    cases.begin("thresholds_zero", r);
    cases.edge(cases.between({0, 0}, {8 * t, 0}));
    cases.edge(plain(cases, {0, 0}, {8 * t, 0}));
    In in = cases.between({t, t}, {5 * t, 3 * t});
    in.p2.x = -1;
    cases.edge(in);
    in.vertices[2].displaced_normal.y = 1;
    cases.edge(in);

    r.view_threshold = ViewTest<Fixed>::max_threshold(profile);
    r.normal_threshold = (1 << profile.displaced_normal.width) - 1;
    r.height_test.threshold = static_cast<uint64_t>(cases.max_height());
    cases.begin("thresholds_max", r);
    in.p1 = {least, least, false}, in.p2 = {most, most, false};
    in.vertices[2].displaced_normal.y = static_cast<int32_t>(profile.displaced_normal.min_raw());
    cases.edge(in);
    in.p1.near = true;
    cases.edge(in);
}

/// Edges that read, edges that do not, and all the ways to be skipped, one after the other: the
/// order is kept, whatever each costs.
void mixed_pace(EdgeScenarios& cases) {
    const int32_t t = cases.texel();
    const Registers r = cases.registers();
    cases.begin("mixed_pace", r);
    for (int32_t i = 0; i < 16; ++i) {
        In in = plain(cases, {i % 5 * t, i % 3 * t}, {(8 - i % 4) * t, 7 * t});
        in.eligible = i % 7 != 3;
        in.p1.near = i % 5 != 1;
        if (i % 4 == 2) in.vertices[1].displaced_normal.x = r.normal_threshold + 1;
        if (i % 6 == 4) in.u2 = in.u12 = in.u1;
        cases.edge(in);
    }
}

}  // namespace

std::vector<Scenario> tessellation_tests_cases(const Profile& profile) {
    EdgeScenarios cases(profile);
    each_alone(cases, profile);
    every_result(cases);
    seams(cases);
    borders(cases, profile);
    mixed_pace(cases);
    return cases.take();
}

}  // namespace repousse::cosim
