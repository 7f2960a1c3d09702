#pragma once

#include "datapath/unit_desc.h"

namespace repousse {

/// Registers are addressed by four bits. One lane: 0-3 differences, 4-11 vertices, 12-15 invalid.
/// Two lanes hold the last vertex kept in the column FIFO as well, of both columns, and one more
/// edge vertex: 4-14 vertices, 15 invalid.
inline constexpr int kSweepOneLaneRegisters = 12;
inline constexpr int kSweepTwoLaneRegisters = 15;

/// A step sends up to four commands and, with them, up to four vertices.
inline constexpr int kSweepStepVertices = 4;

namespace sweep_line_ports {

constexpr Port flag(std::string_view name, std::string_view doc) {
    return {PortKind::Input, name, "", 1, true, doc};
}
constexpr Port number(std::string_view name, int bits, std::string_view doc) {
    return {PortKind::Input, name, "", bits, true, doc};
}
constexpr Port coordinate(std::string_view name, std::string_view doc) {
    return {PortKind::Input, name, "", 14, false, doc};
}
/// Vertex data as the adders hold it: sweep_data, or inverse_w, and the guard bits.
constexpr Port vector(std::string_view name, std::string_view doc) {
    return {PortKind::Input, name,        "sweep_data", 0, false, doc,
            "components",    "inverse_w", "guard_bits"};
}
constexpr Port rest(std::string_view name, int bits, std::string_view doc) {
    return {PortKind::Input, name, "", bits, true, doc, "components"};
}
constexpr Port out(std::string_view name, int bits, std::string_view doc) {
    return {PortKind::Output, name, "", bits, true, doc};
}
constexpr Port out_coordinate(std::string_view name, std::string_view doc) {
    return {PortKind::Output, name, "", 14, false, doc};
}
constexpr Port out_data(std::string_view name, std::string_view doc) {
    return {PortKind::Output, name, "sweep_data", 0, false, doc, "components", "inverse_w"};
}

}  // namespace sweep_line_ports

/// One item is a SweepTriangle without what follows from the rest: a modulus is twice a number of
/// steps, or twice the determinant; exact accumulators start with half a modulus as remainder; the
/// sweep coordinate of the second walk's start is one primary edge away.
///
/// A walk runs along the primary edge, an edge along a half's other side, each from a corner to a
/// corner, in steps. One beat is a SweepStep; what it does not use is 0.
inline constexpr Port kSweepLinePorts[] = {
    {PortKind::Config, "abort_all", "", 1, true, "end every triangle at once, with an empty beat"},
    sweep_line_ports::flag("single", "all corners on one grid point: send the triangle whole"),
    sweep_line_ports::flag("continues", "the second half goes on where the first one ended"),
    sweep_line_ports::flag("mirrored", "the side axis is negated in the local frame"),
    sweep_line_ports::coordinate("sweep_start", "sweep coordinate of walk 0's start"),
    sweep_line_ports::number("determinant", 27, "twice the projected area, 0 to 2^26"),
    sweep_line_ports::number("step_limit", 17, "most steps of a column: the runaway guard"),
    sweep_line_ports::number("half0_columns", 14, "0 to 8192; 0: nothing to do"),
    sweep_line_ports::flag("half0_down", "the sweep runs in decreasing direction"),
    sweep_line_ports::flag("half0_flip", "triangles are wound the other way"),
    sweep_line_ports::flag("half0_tip", "starts at an end of the primary edge"),
    sweep_line_ports::flag("half0_closing", "ends at an end of the primary edge"),
    sweep_line_ports::flag("half0_other_left", "first left column: the other half's edge"),
    sweep_line_ports::flag("half0_other_right", "last right column: the other half's edge"),
    sweep_line_ports::number("half1_columns", 14, ""),
    sweep_line_ports::flag("half1_down", ""),
    sweep_line_ports::flag("half1_flip", ""),
    sweep_line_ports::flag("half1_tip", ""),
    sweep_line_ports::flag("half1_closing", ""),
    sweep_line_ports::flag("half1_other_left", ""),
    sweep_line_ports::flag("half1_other_right", ""),
    sweep_line_ports::number("walk0_edge", 2,
                             "of the base triangle, from corner e to corner (e+1)%3"),
    sweep_line_ports::number("walk0_from", 2, "corner"),
    sweep_line_ports::number("walk0_to", 2, "corner"),
    sweep_line_ports::flag("walk0_backward", "step names count down, from `steps`"),
    sweep_line_ports::number("walk0_steps", 14, "1 to 8192"),
    sweep_line_ports::coordinate("walk0_row", "side coordinate at its start, local frame"),
    {PortKind::Input, "walk0_row_quotient", "", 2, false, "rows a step: -1, 0 or 1"},
    sweep_line_ports::number("walk0_row_rest", 15, "and the rest, in units of 1/(2 steps)"),
    sweep_line_ports::number("walk1_edge", 2, ""),
    sweep_line_ports::number("walk1_from", 2, ""),
    sweep_line_ports::number("walk1_to", 2, ""),
    sweep_line_ports::flag("walk1_backward", ""),
    sweep_line_ports::number("walk1_steps", 14, ""),
    sweep_line_ports::coordinate("walk1_row", ""),
    {PortKind::Input, "walk1_row_quotient", "", 2, false, ""},
    sweep_line_ports::number("walk1_row_rest", 15, ""),
    sweep_line_ports::number("edge0_edge", 2, ""),
    sweep_line_ports::number("edge0_from", 2, ""),
    sweep_line_ports::number("edge0_to", 2, ""),
    sweep_line_ports::flag("edge0_backward", ""),
    sweep_line_ports::number("edge0_steps", 14, ""),
    sweep_line_ports::coordinate("edge0_row", ""),
    {PortKind::Input, "edge0_row_quotient", "", 2, false, ""},
    sweep_line_ports::number("edge0_row_rest", 15, ""),
    sweep_line_ports::number("edge1_edge", 2, ""),
    sweep_line_ports::number("edge1_from", 2, ""),
    sweep_line_ports::number("edge1_to", 2, ""),
    sweep_line_ports::flag("edge1_backward", ""),
    sweep_line_ports::number("edge1_steps", 14, ""),
    sweep_line_ports::coordinate("edge1_row", ""),
    {PortKind::Input, "edge1_row_quotient", "", 2, false, ""},
    sweep_line_ports::number("edge1_row_rest", 15, ""),
    {PortKind::Input, "corner0", "sweep_data", 0, false, "data of a corner", "components",
     "inverse_w"},
    {PortKind::Input, "corner1", "sweep_data", 0, false, "", "components", "inverse_w"},
    {PortKind::Input, "corner2", "sweep_data", 0, false, "", "components", "inverse_w"},
    sweep_line_ports::vector("walk0_start", "the accumulator at its start"),
    sweep_line_ports::vector("walk0_step", "difference a step: quotient"),
    sweep_line_ports::rest("walk0_rest", 15, "and rest, in units of 1/(2 steps)"),
    sweep_line_ports::vector("walk1_start", ""),
    sweep_line_ports::vector("walk1_step", ""),
    sweep_line_ports::rest("walk1_rest", 15, ""),
    sweep_line_ports::vector("edge0_start", ""),
    sweep_line_ports::vector("edge0_step", ""),
    sweep_line_ports::rest("edge0_rest", 15, ""),
    sweep_line_ports::vector("edge1_start", ""),
    sweep_line_ports::vector("edge1_step", ""),
    sweep_line_ports::rest("edge1_rest", 15, ""),
    sweep_line_ports::vector("base0", "Vbase at the start of each walk"),
    sweep_line_ports::vector("base1", ""),
    sweep_line_ports::vector("sweep_step", "difference a column in increasing direction: quotient"),
    sweep_line_ports::rest("sweep_rest", 27, "and rest, in units of 1/(2 determinant)"),
    sweep_line_ports::vector("side_step", "difference a row up, local frame"),
    sweep_line_ports::rest("side_rest", 27, ""),
    sweep_line_ports::out_data("data3", "a vertex: data, rounded"),
    sweep_line_ports::out("kind3", 2, "name: 0 corner, 1 edge, 2 interior"),
    sweep_line_ports::out("part3", 2, "corner or edge"),
    sweep_line_ports::out_coordinate("a3", "step of the edge, or sweep coordinate"),
    sweep_line_ports::out_coordinate("b3", "side coordinate"),
    sweep_line_ports::out_data("data2", ""),
    sweep_line_ports::out("kind2", 2, ""),
    sweep_line_ports::out("part2", 2, ""),
    sweep_line_ports::out_coordinate("a2", ""),
    sweep_line_ports::out_coordinate("b2", ""),
    sweep_line_ports::out_data("data1", ""),
    sweep_line_ports::out("kind1", 2, ""),
    sweep_line_ports::out("part1", 2, ""),
    sweep_line_ports::out_coordinate("a1", ""),
    sweep_line_ports::out_coordinate("b1", ""),
    sweep_line_ports::out_data("data0", ""),
    sweep_line_ports::out("kind0", 2, ""),
    sweep_line_ports::out("part0", 2, ""),
    sweep_line_ports::out_coordinate("a0", ""),
    sweep_line_ports::out_coordinate("b0", ""),
    sweep_line_ports::out("command3", 6,
                          "operation, strip register, where it is kept; 2 bits each"),
    sweep_line_ports::out("command2", 6, ""),
    sweep_line_ports::out("command1", 6, ""),
    sweep_line_ports::out("command0", 6, ""),
    sweep_line_ports::out("count", 3, "commands, 0 to 4"),
    sweep_line_ports::out("vertex_count", 3, "new vertices, 0 to 4"),
    sweep_line_ports::out("init", 1, "start a new strip first"),
    sweep_line_ports::out("flip", 1, "with init: its winding"),
    sweep_line_ports::out("runaway", 1,
                          "the triangle is given up: a column took more than step_limit steps"),
    sweep_line_ports::out("last", 1, "the last beat of the base triangle"),
};

inline constexpr std::string_view kSweepLineKeys[] = {
    "sweep_data", "inverse_w", "adder_kind", "guard_bits", "column_depth", "components",
};

/// Two lanes: one step a cycle, a quad or a single triangle; data follow the slots by a cycle. The
/// next triangle is accepted while one is remeshed. One lane: one addition a cycle.
inline constexpr UnitDesc kSweepLineDesc = {
    "sweep_line",
    "Gumhold and Huettner 1999, section 3.4.4, figures 14 and 15",
    kSweepLinePorts,
    kSweepLineKeys,
    5,  // latency
    1,  // interval
    2,  // capacity
    1,  // backward latency
    "last",
};

}  // namespace repousse
