`default_nettype none

module split_replay #(
`include "rtl/units/split_params.svh"
    , parameter integer COUNT = 1
    , parameter integer BEATS = 1
);
    localparam integer RW = 1;
    localparam integer IW = 15 + 18 * POSITION_WIDTH;
    localparam integer OW = 16;

    wire             clk, rst_n, in_valid, in_ready, out_valid, out_ready;
    wire [RW+IW-1:0] line;
    wire [31:0]      unused_eagerness;
    wire             has_surface_test;
    wire [2:0]       eligible, ct, vt, nt, sht;
    wire [1:0]       digit;
    wire [2:0]       vertex1, vertex2, vertex3, unsplit;
    wire             pass, last;
    wire [4:0]       unused_load;
    wire [POSITION_WIDTH-1:0]
        corner1_x, corner1_y, corner1_z, corner2_x, corner2_y, corner2_z, corner3_x, corner3_y,
        corner3_z, mid12_x, mid12_y, mid12_z, mid23_x, mid23_y, mid23_z, mid31_x, mid31_y, mid31_z;

    replay_stream #(.COUNT(COUNT), .BEATS(BEATS), .RW(RW), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready),
        .out_valid(out_valid), .out_ready(out_ready),
        .out_bits({digit, vertex1, vertex2, vertex3, unsplit, pass, last}), .out_last(last),
        .eagerness(unused_eagerness)
    );

    assign {
        has_surface_test, eligible, ct, vt, nt, sht,
        corner1_x, corner1_y, corner1_z, corner2_x, corner2_y, corner2_z, corner3_x, corner3_y,
        corner3_z, mid12_x, mid12_y, mid12_z, mid23_x, mid23_y, mid23_z, mid31_x, mid31_y, mid31_z
    } = line;

    split #(
        .POSITION_WIDTH(POSITION_WIDTH), .POSITION_FRAC(POSITION_FRAC),
        .DIAGONAL_WIDTH(DIAGONAL_WIDTH), .DIAGONAL_FRAC(DIAGONAL_FRAC)
    ) unit (
        .clk(clk), .rst_n(rst_n), .has_surface_test(has_surface_test),
        .in_valid(in_valid), .in_ready(in_ready),
        .eligible(eligible), .ct(ct), .vt(vt), .nt(nt), .sht(sht),
        .corner1_x(corner1_x), .corner1_y(corner1_y), .corner1_z(corner1_z),
        .corner2_x(corner2_x), .corner2_y(corner2_y), .corner2_z(corner2_z),
        .corner3_x(corner3_x), .corner3_y(corner3_y), .corner3_z(corner3_z), .mid12_x(mid12_x),
        .mid12_y(mid12_y), .mid12_z(mid12_z), .mid23_x(mid23_x), .mid23_y(mid23_y),
        .mid23_z(mid23_z), .mid31_x(mid31_x), .mid31_y(mid31_y), .mid31_z(mid31_z),
        .out_valid(out_valid), .out_ready(out_ready),
        .digit(digit), .vertex1(vertex1), .vertex2(vertex2), .vertex3(vertex3),
        .unsplit(unsplit), .pass(pass), .last(last), .load(unused_load)
    );
endmodule

`default_nettype wire
