`default_nettype none

module height_test_replay #(
`include "rtl/units/height_test_params.svh"
    , parameter integer COUNT = 1
    , parameter integer ENTRIES = 1
);
    localparam integer PLACE = 21;  // bits of a table's place in the file
    localparam integer RW = 13 + 13 + 3 + SAT_WIDTH + PLACE;
    localparam integer IW = 1 + 6 * UV_WIDTH;
    localparam integer OW = 1;

    wire                   clk, rst_n, in_valid, in_ready, out_valid, out_ready, sht;
    wire [RW+IW+OW-1:0]    line;
    wire [31:0]            eagerness;
    wire [12:0]            map_width, map_height;
    wire                   wrap, literal, sum;
    wire [SAT_WIDTH-1:0]   threshold;
    wire [PLACE-1:0]       first_entry;
    wire                   skip;
    wire [UV_WIDTH-1:0]    u1_x, u1_y, u2_x, u2_y, u12_x, u12_y;
    wire                   sat_valid, sat_ready, sat_rvalid, sat_rready;
    wire [2:0]             sat_read;
    wire [3*13-1:0]        sat_x, sat_y;
    wire [3*SAT_WIDTH-1:0] sat_rdata;

    replay_stream #(.COUNT(COUNT), .RW(RW), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready),
        .out_valid(out_valid), .out_ready(out_ready), .out_bits(sht),
        .out_last(1'b1), .eagerness(eagerness)
    );

    assign {map_width, map_height, wrap, literal, sum, threshold, first_entry}
         = line[IW + OW +: RW];
    assign {skip, u1_x, u1_y, u2_x, u2_y, u12_x, u12_y} = line[OW +: IW];

    replay_memory #(.DW(SAT_WIDTH), .N(3), .ENTRIES(ENTRIES)) memory (
        .clk(clk), .rst_n(rst_n), .eagerness(eagerness),
        .first_entry({11'd0, first_entry}), .columns({19'd0, map_width} + 32'd1),
        .valid(sat_valid), .ready(sat_ready), .read(sat_read), .x(sat_x), .y(sat_y),
        .rvalid(sat_rvalid), .rready(sat_rready), .rdata(sat_rdata)
    );

    height_test #(
        .UV_WIDTH(UV_WIDTH), .UV_FRAC(UV_FRAC), .SAT_WIDTH(SAT_WIDTH), .HEIGHT_WIDTH(HEIGHT_WIDTH)
    ) unit (
        .clk(clk), .rst_n(rst_n),
        .map_width(map_width), .map_height(map_height),
        .wrap(wrap), .literal(literal), .sum(sum), .threshold(threshold),
        .in_valid(in_valid), .in_ready(in_ready),
        .skip(skip), .u1_x(u1_x), .u1_y(u1_y), .u2_x(u2_x), .u2_y(u2_y),
        .u12_x(u12_x), .u12_y(u12_y),
        .sat_valid(sat_valid), .sat_ready(sat_ready), .sat_read(sat_read),
        .sat_x(sat_x), .sat_y(sat_y),
        .sat_rvalid(sat_rvalid), .sat_rready(sat_rready), .sat_rdata(sat_rdata),
        .out_valid(out_valid), .out_ready(out_ready), .sht(sht)
    );
endmodule

`default_nettype wire
