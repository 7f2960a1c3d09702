`default_nettype none

module sweep_line_replay #(
`include "rtl/units/sweep_line_params.svh"
    , parameter integer COUNT = 1
    , parameter integer BEATS = 1
);
    localparam integer C  = COMPONENTS;
    localparam integer DW = SWEEP_DATA_WIDTH > INVERSE_W_WIDTH ? SWEEP_DATA_WIDTH
                                                               : INVERSE_W_WIDTH;
    localparam integer VW = DW + GUARD_BITS;
    localparam integer IW = 309 + 3*C*DW + 12*C*VW + 4*C*15 + 2*C*27;
    localparam integer NW = C*DW + 32;          // a vertex
    localparam integer OW = 4*NW + 24 + 10;

    wire          clk, rst_n, in_valid, in_ready, out_valid, out_ready, abort_all;
    wire [IW:0]   line;
    wire [31:0]   unused_eagerness;
    wire          unused_runaway;

`include "testbench/cosim/replay/sweep_line_wires.svh"

    wire [C*DW-1:0] data0, data1, data2, data3;
    wire [1:0]    kind0, kind1, kind2, kind3, part0, part1, part2, part3;
    wire [13:0]   a0, a1, a2, a3, b0, b1, b2, b3;
    wire [5:0]    command0, command1, command2, command3;
    wire [2:0]    count, vertex_count;
    wire          init, flip, runaway, last;

    // Of the vertices, only those that the beat has mean anything.
    wire [4*NW-1:0] vertices = {{data3, kind3, part3, a3, b3} & {NW{vertex_count > 3'd3}},
                                {data2, kind2, part2, a2, b2} & {NW{vertex_count > 3'd2}},
                                {data1, kind1, part1, a1, b1} & {NW{vertex_count > 3'd1}},
                                {data0, kind0, part0, a0, b0} & {NW{vertex_count > 3'd0}}};

    replay_stream #(.COUNT(COUNT), .BEATS(BEATS), .RW(1), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready), .out_valid(out_valid), .out_ready(out_ready),
        .out_bits({vertices, command3, command2, command1, command0, count, vertex_count,
                   init, flip, runaway, last}),
        .out_last(last), .eagerness(unused_eagerness)
    );

    assign {abort_all,
`include "rtl/units/sweep_line_scalars.svh"
        ,
`include "rtl/units/sweep_line_vectors.svh"
    } = line;

    sweep_line #(
        .SWEEP_DATA_WIDTH(SWEEP_DATA_WIDTH), .INVERSE_W_WIDTH(INVERSE_W_WIDTH),
        .ADDER_KIND(ADDER_KIND), .GUARD_BITS(GUARD_BITS), .COLUMN_DEPTH(COLUMN_DEPTH),
        .COMPONENTS(COMPONENTS)
    ) unit (
        .clk(clk), .rst_n(rst_n), .abort_all(abort_all), .runaway_seen(unused_runaway),
        .in_valid(in_valid), .in_ready(in_ready), .out_valid(out_valid), .out_ready(out_ready),
`include "rtl/units/sweep_line_item.svh"
        .data0(data0), .data1(data1), .data2(data2), .data3(data3), .kind0(kind0), .kind1(kind1),
        .kind2(kind2), .kind3(kind3), .part0(part0), .part1(part1), .part2(part2), .part3(part3),
        .a0(a0), .a1(a1), .a2(a2), .a3(a3), .b0(b0), .b1(b1), .b2(b2), .b3(b3),
        .command0(command0), .command1(command1), .command2(command2), .command3(command3),
        .count(count), .vertex_count(vertex_count), .init(init), .flip(flip), .runaway(runaway),
        .last(last)
    );
endmodule

`default_nettype wire
