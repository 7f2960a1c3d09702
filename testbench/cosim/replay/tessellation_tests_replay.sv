`default_nettype none

module tessellation_tests_replay #(
`include "rtl/tops/tessellation_tests_params.svh"
    , parameter integer COUNT = 1
    , parameter integer ENTRIES = 1
);
    localparam integer PLACE = 21;  // bits of a table's place in the file
    localparam integer DW = DISPLACED_NORMAL_WIDTH;
    localparam integer MW = MAP_NORMAL_WIDTH;
    localparam integer BW = NORMAL_WIDTH;
    localparam integer RW = 4 + SCREEN_WIDTH + 1 + DW + 1 + 13 + 13 + 3 + SAT_WIDTH + PLACE;
    localparam integer IW = 1 + 6 * UV_WIDTH + 2 + 4 * SCREEN_WIDTH + 9 * (DW + MW + BW);
    localparam integer OW = 5;

    wire                    clk, rst_n, in_valid, in_ready, out_valid, out_ready;
    wire                    split, ct, vt, nt, sht;
    wire [RW+IW+OW-1:0]     line;
    wire [31:0]             eagerness;
    wire                    eager, use_view_test, use_normal_test, use_height_test;
    wire [SCREEN_WIDTH:0]   view_threshold;
    wire [DW-1:0]           normal_threshold;
    wire [12:0]             map_width, map_height;
    wire                    map_space, wrap, literal, sum;
    wire [SAT_WIDTH-1:0]    height_threshold;
    wire [PLACE-1:0]        first_entry;
    wire                    eligible, near1, near2;
    wire [UV_WIDTH-1:0]     u1_x, u1_y, u2_x, u2_y, u12_x, u12_y;
    wire [SCREEN_WIDTH-1:0] x1, y1, x2, y2;
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
    wire                    sat_valid, sat_ready, sat_rvalid, sat_rready;
    wire [2:0]              sat_read;
    wire [3*13-1:0]         sat_x, sat_y;
    wire [3*SAT_WIDTH-1:0]  sat_rdata;

    replay_stream #(.COUNT(COUNT), .RW(RW), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready),
        .out_valid(out_valid), .out_ready(out_ready), .out_bits({split, ct, vt, nt, sht}),
        .out_last(1'b1), .eagerness(eagerness)
    );

    assign {
        eager, use_view_test, use_normal_test, use_height_test, view_threshold, normal_threshold,
        map_space, map_width, map_height, wrap, literal, sum, height_threshold, first_entry
    } = line[IW + OW +: RW];
    assign {
        eligible, u1_x, u1_y, u2_x, u2_y, u12_x, u12_y, near1, x1, y1, near2, x2, y2,
        displaced_normal1_x, displaced_normal1_y, displaced_normal1_z, map_normal1_x, map_normal1_y,
        map_normal1_z, normal1_x, normal1_y, normal1_z, displaced_normal2_x, displaced_normal2_y,
        displaced_normal2_z, map_normal2_x, map_normal2_y, map_normal2_z, normal2_x, normal2_y,
        normal2_z, displaced_normal12_x, displaced_normal12_y, displaced_normal12_z, map_normal12_x,
        map_normal12_y, map_normal12_z, normal12_x, normal12_y, normal12_z
    } = line[OW +: IW];

    replay_memory #(.DW(SAT_WIDTH), .N(3), .ENTRIES(ENTRIES)) memory (
        .clk(clk), .rst_n(rst_n), .eagerness(eagerness),
        .first_entry({11'd0, first_entry}), .columns({19'd0, map_width} + 32'd1),
        .valid(sat_valid), .ready(sat_ready), .read(sat_read), .x(sat_x), .y(sat_y),
        .rvalid(sat_rvalid), .rready(sat_rready), .rdata(sat_rdata)
    );

    tessellation_tests #(
        .UV_WIDTH(UV_WIDTH), .UV_FRAC(UV_FRAC), .SCREEN_WIDTH(SCREEN_WIDTH),
        .SCREEN_FRAC(SCREEN_FRAC), .DISPLACED_NORMAL_WIDTH(DISPLACED_NORMAL_WIDTH),
        .DISPLACED_NORMAL_FRAC(DISPLACED_NORMAL_FRAC), .MAP_NORMAL_WIDTH(MAP_NORMAL_WIDTH),
        .MAP_NORMAL_FRAC(MAP_NORMAL_FRAC), .NORMAL_WIDTH(NORMAL_WIDTH), .NORMAL_FRAC(NORMAL_FRAC),
        .SAT_WIDTH(SAT_WIDTH), .HEIGHT_WIDTH(HEIGHT_WIDTH)
    ) unit (
        .clk(clk), .rst_n(rst_n),
        .eager(eager), .use_view_test(use_view_test), .use_normal_test(use_normal_test),
        .use_height_test(use_height_test), .view_threshold(view_threshold),
        .normal_threshold(normal_threshold), .map_space(map_space), .map_width(map_width),
        .map_height(map_height), .wrap(wrap), .literal(literal), .sum(sum),
        .height_threshold(height_threshold),
        .in_valid(in_valid), .in_ready(in_ready),
        .eligible(eligible), .u1_x(u1_x), .u1_y(u1_y), .u2_x(u2_x), .u2_y(u2_y), .u12_x(u12_x),
        .u12_y(u12_y), .near1(near1), .x1(x1), .y1(y1), .near2(near2), .x2(x2), .y2(y2),
        .displaced_normal1_x(displaced_normal1_x), .displaced_normal1_y(displaced_normal1_y),
        .displaced_normal1_z(displaced_normal1_z), .map_normal1_x(map_normal1_x),
        .map_normal1_y(map_normal1_y), .map_normal1_z(map_normal1_z), .normal1_x(normal1_x),
        .normal1_y(normal1_y), .normal1_z(normal1_z), .displaced_normal2_x(displaced_normal2_x),
        .displaced_normal2_y(displaced_normal2_y), .displaced_normal2_z(displaced_normal2_z),
        .map_normal2_x(map_normal2_x), .map_normal2_y(map_normal2_y), .map_normal2_z(map_normal2_z),
        .normal2_x(normal2_x), .normal2_y(normal2_y), .normal2_z(normal2_z),
        .displaced_normal12_x(displaced_normal12_x), .displaced_normal12_y(displaced_normal12_y),
        .displaced_normal12_z(displaced_normal12_z), .map_normal12_x(map_normal12_x),
        .map_normal12_y(map_normal12_y), .map_normal12_z(map_normal12_z), .normal12_x(normal12_x),
        .normal12_y(normal12_y), .normal12_z(normal12_z),
        .sat_valid(sat_valid), .sat_ready(sat_ready), .sat_read(sat_read),
        .sat_x(sat_x), .sat_y(sat_y),
        .sat_rvalid(sat_rvalid), .sat_rready(sat_rready), .sat_rdata(sat_rdata),
        .out_valid(out_valid), .out_ready(out_ready), .split(split), .ct(ct), .vt(vt), .nt(nt),
        .sht(sht)
    );
endmodule

`default_nettype wire
