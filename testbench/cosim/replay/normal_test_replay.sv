`default_nettype none

module normal_test_replay #(
`include "rtl/units/normal_test_params.svh"
    , parameter integer COUNT = 1
);
    localparam integer DW = DISPLACED_NORMAL_WIDTH;
    localparam integer MW = MAP_NORMAL_WIDTH;
    localparam integer BW = NORMAL_WIDTH;
    localparam integer RW = DW + 1;
    localparam integer IW = 1 + 9 * (DW + MW + BW);
    localparam integer OW = 1;

    wire                clk, rst_n, in_valid, in_ready, out_valid, out_ready, nt;
    wire [RW+IW+OW-1:0] line;
    wire [31:0]         unused_eagerness;
    wire [DW-1:0]       threshold;
    wire                map_space, skip;
    wire [1:0]          unused_load;
    wire [DW-1:0]
        displaced_normal1_x, displaced_normal1_y, displaced_normal1_z, displaced_normal2_x,
        displaced_normal2_y, displaced_normal2_z, displaced_normal12_x, displaced_normal12_y,
        displaced_normal12_z;
    wire [MW-1:0]
        map_normal1_x, map_normal1_y, map_normal1_z, map_normal2_x, map_normal2_y, map_normal2_z,
        map_normal12_x, map_normal12_y, map_normal12_z;
    wire [BW-1:0]
        normal1_x, normal1_y, normal1_z, normal2_x, normal2_y, normal2_z, normal12_x, normal12_y,
        normal12_z;

    replay_stream #(.COUNT(COUNT), .RW(RW), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready),
        .out_valid(out_valid), .out_ready(out_ready), .out_bits(nt),
        .out_last(1'b1), .eagerness(unused_eagerness)
    );

    assign {threshold, map_space} = line[IW + OW +: RW];
    assign {
        skip, displaced_normal1_x, displaced_normal1_y, displaced_normal1_z, map_normal1_x,
        map_normal1_y, map_normal1_z, normal1_x, normal1_y, normal1_z, displaced_normal2_x,
        displaced_normal2_y, displaced_normal2_z, map_normal2_x, map_normal2_y, map_normal2_z,
        normal2_x, normal2_y, normal2_z, displaced_normal12_x, displaced_normal12_y,
        displaced_normal12_z, map_normal12_x, map_normal12_y, map_normal12_z, normal12_x,
        normal12_y, normal12_z
    } = line[OW +: IW];

    normal_test #(
        .DISPLACED_NORMAL_WIDTH(DISPLACED_NORMAL_WIDTH),
        .DISPLACED_NORMAL_FRAC(DISPLACED_NORMAL_FRAC),
        .MAP_NORMAL_WIDTH(MAP_NORMAL_WIDTH), .MAP_NORMAL_FRAC(MAP_NORMAL_FRAC),
        .NORMAL_WIDTH(NORMAL_WIDTH), .NORMAL_FRAC(NORMAL_FRAC)
    ) unit (
        .clk(clk), .rst_n(rst_n), .threshold(threshold), .map_space(map_space),
        .in_valid(in_valid), .in_ready(in_ready), .skip(skip),
        .displaced_normal1_x(displaced_normal1_x), .displaced_normal1_y(displaced_normal1_y),
        .displaced_normal1_z(displaced_normal1_z), .map_normal1_x(map_normal1_x),
        .map_normal1_y(map_normal1_y), .map_normal1_z(map_normal1_z), .normal1_x(normal1_x),
        .normal1_y(normal1_y), .normal1_z(normal1_z), .displaced_normal2_x(displaced_normal2_x),
        .displaced_normal2_y(displaced_normal2_y), .displaced_normal2_z(displaced_normal2_z),
        .map_normal2_x(map_normal2_x), .map_normal2_y(map_normal2_y),
        .map_normal2_z(map_normal2_z), .normal2_x(normal2_x), .normal2_y(normal2_y),
        .normal2_z(normal2_z), .displaced_normal12_x(displaced_normal12_x),
        .displaced_normal12_y(displaced_normal12_y), .displaced_normal12_z(displaced_normal12_z),
        .map_normal12_x(map_normal12_x), .map_normal12_y(map_normal12_y),
        .map_normal12_z(map_normal12_z), .normal12_x(normal12_x), .normal12_y(normal12_y),
        .normal12_z(normal12_z),
        .out_valid(out_valid), .out_ready(out_ready), .nt(nt), .load(unused_load)
    );
endmodule

`default_nettype wire
