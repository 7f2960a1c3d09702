#pragma once

// The input ports of rtl/units/sweep_line.sv, which the top behind the triangle setup has too.
// Included after <Vunit.h>; the builder defines the RTL's parameters.

#include <type_traits>

#include "testbench/cosim/harness/harness.h"

namespace repousse::harness {

inline constexpr int kSweepLineData =
    SWEEP_DATA_WIDTH > INVERSE_W_WIDTH ? SWEEP_DATA_WIDTH : INVERSE_W_WIDTH;
inline constexpr int kSweepLineValue = kSweepLineData + GUARD_BITS;
inline constexpr int kSweepLineScalars = 52;
inline constexpr int kSweepLineInputs = kSweepLineScalars + 21 * COMPONENTS;

/// Words in the order of the description.
inline void drive_sweep_line(Vunit& top, const int64_t* in) {
    top.single = bits<1>(in[0]);
    top.continues = bits<1>(in[1]);
    top.mirrored = bits<1>(in[2]);
    top.sweep_start = bits<14>(in[3]);
    top.determinant = bits<27>(in[4]);
    top.step_limit = bits<17>(in[5]);
    top.half0_columns = bits<14>(in[6]);
    top.half0_down = bits<1>(in[7]);
    top.half0_flip = bits<1>(in[8]);
    top.half0_tip = bits<1>(in[9]);
    top.half0_closing = bits<1>(in[10]);
    top.half0_other_left = bits<1>(in[11]);
    top.half0_other_right = bits<1>(in[12]);
    top.half1_columns = bits<14>(in[13]);
    top.half1_down = bits<1>(in[14]);
    top.half1_flip = bits<1>(in[15]);
    top.half1_tip = bits<1>(in[16]);
    top.half1_closing = bits<1>(in[17]);
    top.half1_other_left = bits<1>(in[18]);
    top.half1_other_right = bits<1>(in[19]);
    top.walk0_edge = bits<2>(in[20]);
    top.walk0_from = bits<2>(in[21]);
    top.walk0_to = bits<2>(in[22]);
    top.walk0_backward = bits<1>(in[23]);
    top.walk0_steps = bits<14>(in[24]);
    top.walk0_row = bits<14>(in[25]);
    top.walk0_row_quotient = bits<2>(in[26]);
    top.walk0_row_rest = bits<15>(in[27]);
    top.walk1_edge = bits<2>(in[28]);
    top.walk1_from = bits<2>(in[29]);
    top.walk1_to = bits<2>(in[30]);
    top.walk1_backward = bits<1>(in[31]);
    top.walk1_steps = bits<14>(in[32]);
    top.walk1_row = bits<14>(in[33]);
    top.walk1_row_quotient = bits<2>(in[34]);
    top.walk1_row_rest = bits<15>(in[35]);
    top.edge0_edge = bits<2>(in[36]);
    top.edge0_from = bits<2>(in[37]);
    top.edge0_to = bits<2>(in[38]);
    top.edge0_backward = bits<1>(in[39]);
    top.edge0_steps = bits<14>(in[40]);
    top.edge0_row = bits<14>(in[41]);
    top.edge0_row_quotient = bits<2>(in[42]);
    top.edge0_row_rest = bits<15>(in[43]);
    top.edge1_edge = bits<2>(in[44]);
    top.edge1_from = bits<2>(in[45]);
    top.edge1_to = bits<2>(in[46]);
    top.edge1_backward = bits<1>(in[47]);
    top.edge1_steps = bits<14>(in[48]);
    top.edge1_row = bits<14>(in[49]);
    top.edge1_row_quotient = bits<2>(in[50]);
    top.edge1_row_rest = bits<15>(in[51]);
    const int64_t* word = in + kSweepLineScalars;
    const auto vector = [&](auto& port, auto width) {
        drive_vector<decltype(width)::value>(port, word, COMPONENTS);
        word += COMPONENTS;
    };
    constexpr std::integral_constant<int, kSweepLineData> data{};
    constexpr std::integral_constant<int, kSweepLineValue> value{};
    constexpr std::integral_constant<int, 15> edge_rest{};
    constexpr std::integral_constant<int, 27> inside_rest{};
    vector(top.corner0, data);
    vector(top.corner1, data);
    vector(top.corner2, data);
    vector(top.walk0_start, value);
    vector(top.walk0_step, value);
    vector(top.walk0_rest, edge_rest);
    vector(top.walk1_start, value);
    vector(top.walk1_step, value);
    vector(top.walk1_rest, edge_rest);
    vector(top.edge0_start, value);
    vector(top.edge0_step, value);
    vector(top.edge0_rest, edge_rest);
    vector(top.edge1_start, value);
    vector(top.edge1_step, value);
    vector(top.edge1_rest, edge_rest);
    vector(top.base0, value);
    vector(top.base1, value);
    vector(top.sweep_step, value);
    vector(top.sweep_rest, inside_rest);
    vector(top.side_step, value);
    vector(top.side_rest, inside_rest);
}

}  // namespace repousse::harness
