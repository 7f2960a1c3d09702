#pragma once

#include <array>
#include <cstddef>

#include "datapath/transaction.h"
#include "datapath/units/height_test_desc.h"
#include "datapath/units/normal_test_desc.h"
#include "datapath/units/texcoord_test_desc.h"
#include "datapath/units/view_test_desc.h"

namespace repousse {

namespace tessellation_tests_ports {

/// Registers of the tests and of the chain, one edge's data, its decision and the tests' results.
inline constexpr std::size_t kPorts = 4 + port_count(kViewTestDesc, PortKind::Config) +
                                      port_count(kNormalTestDesc, PortKind::Config) +
                                      port_count(kHeightTestDesc, PortKind::Config) + 1 +
                                      (port_count(kTexcoordTestDesc, PortKind::Input) - 1) +
                                      (port_count(kViewTestDesc, PortKind::Input) - 1) +
                                      (port_count(kNormalTestDesc, PortKind::Input) - 1) + 5;

constexpr Port flag(PortKind kind, std::string_view name, std::string_view doc) {
    return {kind, name, "", 1, true, doc};
}

/// The ports of the tests as they stand, but three thresholds need three names, and in the place of
/// the four `skip` there is one `eligible`.
constexpr auto make() {
    std::array<Port, kPorts> ports{};
    std::size_t n = 0;
    const auto take = [&](const UnitDesc& desc, PortKind kind, std::string_view threshold) {
        for (const Port& port : desc.ports) {
            if (port.kind != kind || port.name == "skip") continue;
            ports[n] = port;
            if (port.name == "threshold") ports[n].name = threshold;
            ++n;
        }
    };
    ports[n++] = flag(PortKind::Config, "eager", "no test is skipped because an edge is decided");
    ports[n++] = flag(PortKind::Config, "use_view_test", "otherwise every edge is long enough");
    ports[n++] = flag(PortKind::Config, "use_normal_test", "otherwise no edge is found by it");
    ports[n++] = flag(PortKind::Config, "use_height_test",
                      "likewise; with neither of the two every edge counts as detailed");
    take(kViewTestDesc, PortKind::Config, "view_threshold");
    take(kNormalTestDesc, PortKind::Config, "normal_threshold");
    take(kHeightTestDesc, PortKind::Config, "height_threshold");
    ports[n++] =
        flag(PortKind::Input, "eligible", "the edge may be split; otherwise it is decided");
    take(kTexcoordTestDesc, PortKind::Input, {});
    take(kViewTestDesc, PortKind::Input, {});
    take(kNormalTestDesc, PortKind::Input, {});
    ports[n++] = flag(PortKind::Output, "split", "the decision");
    ports[n++] = flag(PortKind::Output, "ct", "Tex Coord Test; 1 if skipped");
    ports[n++] = flag(PortKind::Output, "vt", "View Test; 1 if skipped or not used");
    ports[n++] = flag(PortKind::Output, "nt", "Normal Test; 0 if skipped or not used");
    ports[n++] = flag(PortKind::Output, "sht", "Summed Height Test; 0 if skipped or not used");
    return ports;
}

}  // namespace tessellation_tests_ports

inline constexpr auto kTessellationTestsPorts = tessellation_tests_ports::make();

inline constexpr std::string_view kTessellationTestsKeys[] = {
    "uv", "screen", "displaced_normal", "map_normal", "normal", "sat_width", "height"};

inline constexpr std::string_view kTessellationTestsParts[] = {"texcoord_test", "view_test",
                                                               "normal_test", "height_test"};

/// The Verilog top of figure 8: an edge with its new vertex comes in, whether it is split goes out.
/// The figures are those of an edge that every test works on; what is skipped costs one cycle.
inline constexpr UnitDesc kTessellationTestsDesc = {
    "tessellation_tests",
    "Doggett and Hirche 2000, section 3.1, figure 8",
    kTessellationTestsPorts,
    kTessellationTestsKeys,
    kTexcoordTestDesc.latency + kViewTestDesc.latency + kNormalTestDesc.latency +
        kHeightTestDesc.latency,
    kHeightTestDesc.interval,
    kTexcoordTestDesc.capacity + kViewTestDesc.capacity + kNormalTestDesc.capacity +
        kHeightTestDesc.capacity,
    1,  // backward latency: the Summed Height Test's
    {},
    kTessellationTestsParts,
};

}  // namespace repousse
