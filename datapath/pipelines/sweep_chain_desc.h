#pragma once

#include <array>
#include <cstddef>

#include "datapath/transaction.h"
#include "datapath/units/perspective_desc.h"
#include "datapath/units/strip_desc.h"
#include "datapath/units/sweep_line_desc.h"

namespace repousse {

namespace sweep_chain_ports {

/// The vertices of a step's two triangles, the second one first: most steps of a small triangle
/// make one, and a line of a vector file leaves leading zeros out.
inline constexpr std::array<std::string_view, 3 * kStripTriangles> kVertices = {"a1", "b1", "c1",
                                                                                "a0", "b0", "c0"};
inline constexpr std::size_t kFields = port_count(kPerspectiveDesc, PortKind::Output);

/// "a1_x" and so on, for each output of `perspective`.
inline constexpr std::size_t kNameLength = 24;
using Name = std::array<char, kNameLength>;

constexpr auto make_names() {
    std::array<Name, kVertices.size() * kFields> names{};
    std::size_t n = 0;
    for (const std::string_view vertex : kVertices) {
        for (const Port& port : kPerspectiveDesc.ports) {
            if (port.kind != PortKind::Output) continue;
            std::size_t at = 0;
            for (const char c : vertex) names[n][at++] = c;
            names[n][at++] = '_';
            for (const char c : port.name) names[n][at++] = c;
            ++n;
        }
    }
    return names;
}
inline constexpr auto kNames = make_names();

constexpr std::string_view name(std::size_t n) {
    std::size_t length = 0;
    while (kNames[n][length] != '\0') ++length;
    return {kNames[n].data(), length};
}

/// Registers, what enters the sweep line, and what leaves the stripping unit.
inline constexpr std::size_t kPorts =
    2 + port_count(kSweepLineDesc, PortKind::Input) + kVertices.size() * kFields + 4;

constexpr auto make() {
    std::array<Port, kPorts> ports{};
    std::size_t n = 0;
    const auto take = [&](const UnitDesc& desc, PortKind kind) {
        for (const Port& port : desc.ports) {
            if (port.kind == kind) ports[n++] = port;
        }
    };
    take(kSweepLineDesc, PortKind::Config);
    take(kPerspectiveDesc, PortKind::Config);
    take(kSweepLineDesc, PortKind::Input);
    const std::size_t first = n;
    for (std::size_t vertex = 0; vertex < kVertices.size(); ++vertex) {
        take(kPerspectiveDesc, PortKind::Output);
    }
    for (std::size_t i = first; i < n; ++i) ports[i].name = name(i - first);
    ports[n++] = {PortKind::Output, "triangles", "", 2, true, "made by the step, 0 to 2"};
    ports[n++] = {PortKind::Output, "bad_ref", "", 1, true, "a command could not be carried out"};
    ports[n++] = {PortKind::Output, "runaway", "", 1, true, "the base triangle is given up"};
    ports[n++] = {PortKind::Output, "last", "", 1, true, "the last step of the base triangle"};
    return ports;
}

}  // namespace sweep_chain_ports

inline constexpr auto kSweepChainPorts = sweep_chain_ports::make();

inline constexpr std::string_view kSweepChainKeys[] = {
    "uv",
    "position",
    "unnormalised",
    "sweep_data",
    "inverse_w",
    "adder_kind",
    "guard_bits",
    "column_depth",
    "components",
    "reciprocal_index_bits",
    "reciprocal_newton_steps",
    "reciprocal_bits",
};

inline constexpr std::string_view kSweepChainParts[] = {"sweep_line", "perspective", "strip"};

/// The Verilog top behind the triangle setup: an item is a base triangle as `sweep_line` takes it,
/// a beat what `strip` makes of one step, of vertices as they leave `perspective`.
inline constexpr UnitDesc kSweepChainDesc = {
    "sweep_chain",
    "Gumhold and Huettner 1999, figure 3, from the remesher to the stripping unit",
    kSweepChainPorts,
    kSweepChainKeys,
    // latency: of the first step, which has three vertices
    kSweepLineDesc.latency + 3 + kPerspectiveDesc.latency + 1 + kStripDesc.latency,
    1,                        // interval
    kSweepLineDesc.capacity,  // of base triangles whose steps have not all left the sweep line
    1,                        // backward latency
    "last",
    kSweepChainParts,
};

}  // namespace repousse
