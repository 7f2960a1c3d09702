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
`include "testbench/cosim/replay/sweep_line_wires.svh"

    replay_stream #(.COUNT(COUNT), .BEATS(BEATS), .RW(RW), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready), .out_valid(out_valid), .out_ready(out_ready),
        .out_bits({(triangles > 2'd1) ? {a1, b1, c1} : {(3*FW){1'b0}},
                   (triangles > 2'd0) ? {a0, b0, c0} : {(3*FW){1'b0}},
                   triangles, bad_ref, runaway, last}),
        .out_last(last), .eagerness(unused_eagerness)
    );

    assign {abort_all, tangents,
`include "rtl/units/sweep_line_scalars.svh"
        ,
`include "rtl/units/sweep_line_vectors.svh"
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
`include "rtl/units/sweep_line_item.svh"
        .out_valid(out_valid), .out_ready(out_ready), .a1(a1), .b1(b1), .c1(c1), .a0(a0), .b0(b0),
        .c0(c0), .triangles(triangles), .bad_ref(bad_ref), .runaway(runaway), .last(last)
    );
endmodule

`default_nettype wire
