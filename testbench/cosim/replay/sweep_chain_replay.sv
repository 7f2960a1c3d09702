`default_nettype none

// Triangles that were not made are undefined, and 0 in the file.
module sweep_chain_replay #(
`include "rtl/tops/sweep_chain_params.svh"
    , parameter integer COUNT = 1
    , parameter integer BEATS = 1
);
    localparam integer C  = COMPONENTS;
    localparam integer DW = SWEEP_DATA_WIDTH > INVERSE_W_WIDTH ? SWEEP_DATA_WIDTH : INVERSE_W_WIDTH;
    localparam integer VW = DW + GUARD_BITS;
    localparam integer FW = 3*POSITION_WIDTH + 6*UNNORMALISED_WIDTH + 2*UV_WIDTH + 2;
    localparam integer RW = 2;
    localparam integer IW = 309 + 3*C*DW + 12*C*VW + 4*C*15 + 2*C*27;
    localparam integer OW = 6*FW + 5;

    wire             clk, rst_n, in_valid, in_ready, out_valid, out_ready;
    wire [RW+IW-1:0] line;
    wire [31:0]      unused_eagerness;
    wire             abort_all, tangents, bad_ref, runaway, last;
    wire [FW-1:0]    a0, b0, c0, a1, b1, c1;
    wire [1:0]       triangles;
    wire
         single, continues, mirrored, half0_down, half0_flip, half0_tip, half0_closing,
         half0_other_left, half0_other_right, half1_down, half1_flip, half1_tip, half1_closing,
         half1_other_left, half1_other_right, walk0_backward, walk1_backward, edge0_backward,
         edge1_backward;
    wire [13:0]
         sweep_start, half0_columns, half1_columns, walk0_steps, walk0_row, walk1_steps, walk1_row,
         edge0_steps, edge0_row, edge1_steps, edge1_row;
    wire [26:0]
         determinant;
    wire [16:0]
         step_limit;
    wire [1:0]
         walk0_edge, walk0_from, walk0_to, walk0_row_quotient, walk1_edge, walk1_from, walk1_to,
         walk1_row_quotient, edge0_edge, edge0_from, edge0_to, edge0_row_quotient, edge1_edge,
         edge1_from, edge1_to, edge1_row_quotient;
    wire [14:0]
         walk0_row_rest, walk1_row_rest, edge0_row_rest, edge1_row_rest;
    wire [C*DW-1:0]
         corner0, corner1, corner2;
    wire [C*VW-1:0]
         walk0_start, walk0_step, walk1_start, walk1_step, edge0_start, edge0_step, edge1_start,
         edge1_step, base0, base1, sweep_step, side_step;
    wire [C*15-1:0]
         walk0_rest, walk1_rest, edge0_rest, edge1_rest;
    wire [C*27-1:0]
         sweep_rest, side_rest;

    replay_beats #(.COUNT(COUNT), .BEATS(BEATS), .RW(RW), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready), .out_valid(out_valid), .out_ready(out_ready),
        .out_bits({(triangles > 2'd1) ? {a1, b1, c1} : {(3*FW){1'b0}},
                   (triangles > 2'd0) ? {a0, b0, c0} : {(3*FW){1'b0}},
                   triangles, bad_ref, runaway, last}),
        .out_last(last), .eagerness(unused_eagerness)
    );

    assign {
        abort_all, tangents, single, continues, mirrored, sweep_start, determinant, step_limit,
        half0_columns, half0_down, half0_flip, half0_tip, half0_closing, half0_other_left,
        half0_other_right, half1_columns, half1_down, half1_flip, half1_tip, half1_closing,
        half1_other_left, half1_other_right, walk0_edge, walk0_from, walk0_to, walk0_backward,
        walk0_steps, walk0_row, walk0_row_quotient, walk0_row_rest, walk1_edge, walk1_from,
        walk1_to, walk1_backward, walk1_steps, walk1_row, walk1_row_quotient, walk1_row_rest,
        edge0_edge, edge0_from, edge0_to, edge0_backward, edge0_steps, edge0_row,
        edge0_row_quotient, edge0_row_rest, edge1_edge, edge1_from, edge1_to, edge1_backward,
        edge1_steps, edge1_row, edge1_row_quotient, edge1_row_rest, corner0, corner1, corner2,
        walk0_start, walk0_step, walk0_rest, walk1_start, walk1_step, walk1_rest, edge0_start,
        edge0_step, edge0_rest, edge1_start, edge1_step, edge1_rest, base0, base1, sweep_step,
        sweep_rest, side_step, side_rest
    } = line;

    sweep_chain #(
        .UV_WIDTH(UV_WIDTH), .UV_FRAC(UV_FRAC), .POSITION_WIDTH(POSITION_WIDTH),
        .POSITION_FRAC(POSITION_FRAC), .UNNORMALISED_WIDTH(UNNORMALISED_WIDTH),
        .UNNORMALISED_FRAC(UNNORMALISED_FRAC), .SWEEP_DATA_WIDTH(SWEEP_DATA_WIDTH),
        .SWEEP_DATA_FRAC(SWEEP_DATA_FRAC), .INVERSE_W_WIDTH(INVERSE_W_WIDTH),
        .INVERSE_W_FRAC(INVERSE_W_FRAC), .ADDER_KIND(ADDER_KIND), .GUARD_BITS(GUARD_BITS),
        .COLUMN_DEPTH(COLUMN_DEPTH), .COMPONENTS(COMPONENTS),
        .RECIPROCAL_INDEX_BITS(RECIPROCAL_INDEX_BITS),
        .RECIPROCAL_NEWTON_STEPS(RECIPROCAL_NEWTON_STEPS), .RECIPROCAL_BITS(RECIPROCAL_BITS)
    ) top (
        .clk(clk), .rst_n(rst_n), .abort_all(abort_all), .tangents(tangents),
        .in_valid(in_valid), .in_ready(in_ready),
        .single(single), .continues(continues), .mirrored(mirrored), .sweep_start(sweep_start),
        .determinant(determinant), .step_limit(step_limit), .half0_columns(half0_columns),
        .half0_down(half0_down), .half0_flip(half0_flip), .half0_tip(half0_tip),
        .half0_closing(half0_closing), .half0_other_left(half0_other_left),
        .half0_other_right(half0_other_right), .half1_columns(half1_columns),
        .half1_down(half1_down), .half1_flip(half1_flip), .half1_tip(half1_tip),
        .half1_closing(half1_closing), .half1_other_left(half1_other_left),
        .half1_other_right(half1_other_right), .walk0_edge(walk0_edge), .walk0_from(walk0_from),
        .walk0_to(walk0_to), .walk0_backward(walk0_backward), .walk0_steps(walk0_steps),
        .walk0_row(walk0_row), .walk0_row_quotient(walk0_row_quotient),
        .walk0_row_rest(walk0_row_rest), .walk1_edge(walk1_edge), .walk1_from(walk1_from),
        .walk1_to(walk1_to), .walk1_backward(walk1_backward), .walk1_steps(walk1_steps),
        .walk1_row(walk1_row), .walk1_row_quotient(walk1_row_quotient),
        .walk1_row_rest(walk1_row_rest), .edge0_edge(edge0_edge), .edge0_from(edge0_from),
        .edge0_to(edge0_to), .edge0_backward(edge0_backward), .edge0_steps(edge0_steps),
        .edge0_row(edge0_row), .edge0_row_quotient(edge0_row_quotient),
        .edge0_row_rest(edge0_row_rest), .edge1_edge(edge1_edge), .edge1_from(edge1_from),
        .edge1_to(edge1_to), .edge1_backward(edge1_backward), .edge1_steps(edge1_steps),
        .edge1_row(edge1_row), .edge1_row_quotient(edge1_row_quotient),
        .edge1_row_rest(edge1_row_rest), .corner0(corner0), .corner1(corner1), .corner2(corner2),
        .walk0_start(walk0_start), .walk0_step(walk0_step), .walk0_rest(walk0_rest),
        .walk1_start(walk1_start), .walk1_step(walk1_step), .walk1_rest(walk1_rest),
        .edge0_start(edge0_start), .edge0_step(edge0_step), .edge0_rest(edge0_rest),
        .edge1_start(edge1_start), .edge1_step(edge1_step), .edge1_rest(edge1_rest), .base0(base0),
        .base1(base1), .sweep_step(sweep_step), .sweep_rest(sweep_rest), .side_step(side_step),
        .side_rest(side_rest),
        .out_valid(out_valid), .out_ready(out_ready), .a1(a1), .b1(b1), .c1(c1), .a0(a0), .b0(b0),
        .c0(c0), .triangles(triangles), .bad_ref(bad_ref), .runaway(runaway), .last(last)
    );
endmodule

`default_nettype wire
