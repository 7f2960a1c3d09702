`default_nettype none

module perspective_replay #(
`include "rtl/units/perspective_params.svh"
    , parameter integer COUNT = 1
);
    localparam integer RW = 1;
    localparam integer IW = 12 * SWEEP_DATA_WIDTH + INVERSE_W_WIDTH;
    localparam integer OW = 3 * POSITION_WIDTH + 6 * UNNORMALISED_WIDTH + 2 * UV_WIDTH + 2;

    wire                          clk, rst_n, in_valid, in_ready, out_valid, out_ready;
    wire [RW+IW+OW-1:0]           line;
    wire [31:0]                   unused_eagerness;
    wire                          tangents;
    wire [SWEEP_DATA_WIDTH-1:0]   x_c, y_c, z_c, nx_c, ny_c, nz_c, uv_x_c, uv_y_c;
    wire [SWEEP_DATA_WIDTH-1:0]   tx_c, ty_c, tz_c, handedness_c;
    wire [INVERSE_W_WIDTH-1:0]    c;
    wire [POSITION_WIDTH-1:0]     x, y, z;
    wire [UNNORMALISED_WIDTH-1:0] nx, ny, nz, tx, ty, tz;
    wire [UV_WIDTH-1:0]           uv_x, uv_y;
    wire                          left_handed, clamped;

    replay_stream #(.COUNT(COUNT), .RW(RW), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready),
        .out_valid(out_valid), .out_ready(out_ready),
        .out_bits({x, y, z, nx, ny, nz, uv_x, uv_y, tx, ty, tz, left_handed, clamped}),
        .out_last(1'b1), .eagerness(unused_eagerness)
    );

    assign tangents = line[IW + OW +: RW];
    assign {x_c, y_c, z_c, nx_c, ny_c, nz_c, uv_x_c, uv_y_c, c, tx_c, ty_c, tz_c, handedness_c}
        = line[OW +: IW];

    perspective #(
        .UV_WIDTH(UV_WIDTH), .UV_FRAC(UV_FRAC),
        .POSITION_WIDTH(POSITION_WIDTH), .POSITION_FRAC(POSITION_FRAC),
        .UNNORMALISED_WIDTH(UNNORMALISED_WIDTH), .UNNORMALISED_FRAC(UNNORMALISED_FRAC),
        .SWEEP_DATA_WIDTH(SWEEP_DATA_WIDTH), .SWEEP_DATA_FRAC(SWEEP_DATA_FRAC),
        .INVERSE_W_WIDTH(INVERSE_W_WIDTH), .INVERSE_W_FRAC(INVERSE_W_FRAC),
        .COMPONENTS(COMPONENTS), .RECIPROCAL_INDEX_BITS(RECIPROCAL_INDEX_BITS),
        .RECIPROCAL_NEWTON_STEPS(RECIPROCAL_NEWTON_STEPS), .RECIPROCAL_BITS(RECIPROCAL_BITS)
    ) unit (
        .clk(clk), .rst_n(rst_n), .tangents(tangents),
        .in_valid(in_valid), .in_ready(in_ready),
        .x_c(x_c), .y_c(y_c), .z_c(z_c), .nx_c(nx_c), .ny_c(ny_c), .nz_c(nz_c),
        .uv_x_c(uv_x_c), .uv_y_c(uv_y_c), .c(c), .tx_c(tx_c), .ty_c(ty_c), .tz_c(tz_c),
        .handedness_c(handedness_c),
        .out_valid(out_valid), .out_ready(out_ready),
        .x(x), .y(y), .z(z), .nx(nx), .ny(ny), .nz(nz), .uv_x(uv_x), .uv_y(uv_y),
        .tx(tx), .ty(ty), .tz(tz), .left_handed(left_handed), .clamped(clamped)
    );
endmodule

`default_nettype wire
