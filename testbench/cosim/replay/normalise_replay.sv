`default_nettype none

module normalise_replay #(
`include "rtl/units/normalise_params.svh"
    , parameter integer COUNT = 1
);
    localparam integer IW = 3 * UNNORMALISED_WIDTH;
    localparam integer OW = 3 * NORMAL_WIDTH;

    wire                          clk, rst_n, in_valid, in_ready, out_valid, out_ready;
    wire [IW+OW-1:0]              line;
    wire [31:0]                   unused_eagerness;
    wire [UNNORMALISED_WIDTH-1:0] x, y, z;
    wire [NORMAL_WIDTH-1:0]       unit_x, unit_y, unit_z;

    replay_stream #(.COUNT(COUNT), .RW(0), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready),
        .out_valid(out_valid), .out_ready(out_ready),
        .out_bits({unit_x, unit_y, unit_z}), .out_last(1'b1), .eagerness(unused_eagerness)
    );

    assign {x, y, z} = line[OW +: IW];

    normalise #(
        .NORMAL_WIDTH(NORMAL_WIDTH), .NORMAL_FRAC(NORMAL_FRAC),
        .UNNORMALISED_WIDTH(UNNORMALISED_WIDTH), .UNNORMALISED_FRAC(UNNORMALISED_FRAC),
        .NORMALISE_KIND(NORMALISE_KIND), .INVERSE_SQRT_INDEX_BITS(INVERSE_SQRT_INDEX_BITS),
        .INVERSE_SQRT_NEWTON_STEPS(INVERSE_SQRT_NEWTON_STEPS),
        .INVERSE_SQRT_BITS(INVERSE_SQRT_BITS)
    ) unit (
        .clk(clk), .rst_n(rst_n), .in_valid(in_valid), .in_ready(in_ready),
        .x(x), .y(y), .z(z),
        .out_valid(out_valid), .out_ready(out_ready),
        .unit_x(unit_x), .unit_y(unit_y), .unit_z(unit_z)
    );
endmodule

`default_nettype wire
