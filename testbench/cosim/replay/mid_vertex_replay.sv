`default_nettype none

module mid_vertex_replay #(
`include "rtl/units/mid_vertex_params.svh"
    , parameter integer COUNT = 1
);
    localparam integer OW = 2 * UV_WIDTH + 4 + 3 * POSITION_WIDTH + 6 * NORMAL_WIDTH + 1;
    localparam integer IW = 2 * OW;

    wire                      clk, rst_n, in_valid, in_ready, out_valid, out_ready;
    wire [IW+OW-1:0]          line;
    wire [31:0]               unused_eagerness;
    wire [UV_WIDTH-1:0]       u1_x, u1_y, u2_x, u2_y, u12_x, u12_y;
    wire [3:0]                generation1, generation2, generation12;
    wire [POSITION_WIDTH-1:0] p1_x, p1_y, p1_z, p2_x, p2_y, p2_z, p12_x, p12_y, p12_z;
    wire [NORMAL_WIDTH-1:0]   n1_x, n1_y, n1_z, n2_x, n2_y, n2_z, n12_x, n12_y, n12_z;
    wire [NORMAL_WIDTH-1:0]   t1_x, t1_y, t1_z, t2_x, t2_y, t2_z, t12_x, t12_y, t12_z;
    wire                      left1, left2, left12;

    replay_stream #(.COUNT(COUNT), .RW(0), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready),
        .out_valid(out_valid), .out_ready(out_ready),
        .out_bits({u12_x, u12_y, generation12, p12_x, p12_y, p12_z, n12_x, n12_y, n12_z,
                   t12_x, t12_y, t12_z, left12}),
        .out_last(1'b1), .eagerness(unused_eagerness)
    );

    assign {u1_x, u1_y, generation1, p1_x, p1_y, p1_z, n1_x, n1_y, n1_z, t1_x, t1_y, t1_z, left1,
            u2_x, u2_y, generation2, p2_x, p2_y, p2_z, n2_x, n2_y, n2_z, t2_x, t2_y, t2_z,
            left2} = line[OW +: IW];

    mid_vertex #(
        .UV_WIDTH(UV_WIDTH), .UV_FRAC(UV_FRAC),
        .POSITION_WIDTH(POSITION_WIDTH), .POSITION_FRAC(POSITION_FRAC),
        .NORMAL_WIDTH(NORMAL_WIDTH), .NORMAL_FRAC(NORMAL_FRAC),
        .UNNORMALISED_WIDTH(UNNORMALISED_WIDTH), .UNNORMALISED_FRAC(UNNORMALISED_FRAC),
        .NORMALISE_KIND(NORMALISE_KIND), .INVERSE_SQRT_INDEX_BITS(INVERSE_SQRT_INDEX_BITS),
        .INVERSE_SQRT_NEWTON_STEPS(INVERSE_SQRT_NEWTON_STEPS),
        .INVERSE_SQRT_BITS(INVERSE_SQRT_BITS)
    ) unit (
        .clk(clk), .rst_n(rst_n), .in_valid(in_valid), .in_ready(in_ready),
        .u1_x(u1_x), .u1_y(u1_y), .generation1(generation1),
        .p1_x(p1_x), .p1_y(p1_y), .p1_z(p1_z), .n1_x(n1_x), .n1_y(n1_y), .n1_z(n1_z),
        .t1_x(t1_x), .t1_y(t1_y), .t1_z(t1_z), .left1(left1),
        .u2_x(u2_x), .u2_y(u2_y), .generation2(generation2),
        .p2_x(p2_x), .p2_y(p2_y), .p2_z(p2_z), .n2_x(n2_x), .n2_y(n2_y), .n2_z(n2_z),
        .t2_x(t2_x), .t2_y(t2_y), .t2_z(t2_z), .left2(left2),
        .out_valid(out_valid), .out_ready(out_ready),
        .u12_x(u12_x), .u12_y(u12_y), .generation12(generation12),
        .p12_x(p12_x), .p12_y(p12_y), .p12_z(p12_z),
        .n12_x(n12_x), .n12_y(n12_y), .n12_z(n12_z),
        .t12_x(t12_x), .t12_y(t12_y), .t12_z(t12_z), .left12(left12)
    );
endmodule

`default_nettype wire
