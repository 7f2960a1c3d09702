`default_nettype none

module texcoord_test_replay #(
`include "rtl/units/texcoord_test_params.svh"
    , parameter integer COUNT = 1
);
    localparam integer IW = 1 + 6 * UV_WIDTH;
    localparam integer OW = 1;

    wire               clk, rst_n, in_valid, in_ready, out_valid, out_ready, ct;
    wire [IW+OW-1:0]   line;
    wire [31:0]        unused_eagerness;
    wire [UV_WIDTH-1:0] u1_x, u1_y, u2_x, u2_y, u12_x, u12_y;
    wire               skip, unused_load;

    replay_stream #(.COUNT(COUNT), .RW(0), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready),
        .out_valid(out_valid), .out_ready(out_ready), .out_bits(ct),
        .out_last(1'b1), .eagerness(unused_eagerness)
    );

    assign {skip, u1_x, u1_y, u2_x, u2_y, u12_x, u12_y} = line[OW +: IW];

    texcoord_test #(.UV_WIDTH(UV_WIDTH), .UV_FRAC(UV_FRAC)) unit (
        .clk(clk), .rst_n(rst_n), .in_valid(in_valid), .in_ready(in_ready),
        .skip(skip), .u1_x(u1_x), .u1_y(u1_y), .u2_x(u2_x), .u2_y(u2_y),
        .u12_x(u12_x), .u12_y(u12_y),
        .out_valid(out_valid), .out_ready(out_ready), .ct(ct), .load(unused_load)
    );
endmodule

`default_nettype wire
