`default_nettype none

module view_test_replay #(
`include "rtl/units/view_test_params.svh"
    , parameter integer COUNT = 1
);
    localparam integer RW = SCREEN_WIDTH + 1;
    localparam integer IW = 3 + 4 * SCREEN_WIDTH;
    localparam integer OW = 1;

    wire                    clk, rst_n, in_valid, in_ready, out_valid, out_ready, vt;
    wire [RW+IW+OW-1:0]     line;
    wire [31:0]             unused_eagerness;
    wire [SCREEN_WIDTH:0]   threshold;
    wire [SCREEN_WIDTH-1:0] x1, y1, x2, y2;
    wire                    skip, near1, near2;
    wire [1:0]              unused_load;

    replay_stream #(.COUNT(COUNT), .RW(RW), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready),
        .out_valid(out_valid), .out_ready(out_ready), .out_bits(vt),
        .out_last(1'b1), .eagerness(unused_eagerness)
    );

    assign threshold = line[IW + OW +: RW];
    assign {skip, near1, x1, y1, near2, x2, y2} = line[OW +: IW];

    view_test #(.SCREEN_WIDTH(SCREEN_WIDTH), .SCREEN_FRAC(SCREEN_FRAC)) unit (
        .clk(clk), .rst_n(rst_n), .threshold(threshold),
        .in_valid(in_valid), .in_ready(in_ready),
        .skip(skip), .near1(near1), .x1(x1), .y1(y1), .near2(near2), .x2(x2), .y2(y2),
        .out_valid(out_valid), .out_ready(out_ready), .vt(vt), .load(unused_load)
    );
endmodule

`default_nettype wire
