`default_nettype none

// The normalisation of interpolated normals and tangents: v / |v|, by the inverse square root or by
// CORDIC as NORMALISE_KIND says. rp_normalise, which mid_vertex and bump have within them, behind a
// handshake.
//
// Time: latency 16 (CORDIC: 3 (NORMAL_FRAC + 5) + 3), one vector a cycle, in_ready follows
// out_ready.
module normalise #(
`include "rtl/units/normalise_params.svh"
) (
    input  wire                                 clk,
    input  wire                                 rst_n,    // synchronous, low

    input  wire                                 in_valid,
    output wire                                 in_ready,
    input  wire signed [UNNORMALISED_WIDTH-1:0] x,
    input  wire signed [UNNORMALISED_WIDTH-1:0] y,
    input  wire signed [UNNORMALISED_WIDTH-1:0] z,

    output wire                                 out_valid,
    input  wire                                 out_ready,
    output wire signed [NORMAL_WIDTH-1:0]       unit_x,
    output wire signed [NORMAL_WIDTH-1:0]       unit_y,
    output wire signed [NORMAL_WIDTH-1:0]       unit_z
);
    localparam integer BOUND = (NORMAL_FRAC < 4) ? 4 : (NORMAL_FRAC > 18) ? 18 : NORMAL_FRAC;
    localparam integer L     = (NORMALISE_KIND == 0) ? 16 : 3 * (BOUND + 5) + 3;

    wire [L-1:0] load;
    wire         unused_data;

    rp_pipe #(.W(1), .L(L)) stages (
        .clk      (clk),
        .rst_n    (rst_n),
        .in_valid (in_valid),
        .in_ready (in_ready),
        .in_data  (1'b0),
        .out_valid(out_valid),
        .out_ready(out_ready),
        .out_data (unused_data),
        .load     (load)
    );

    rp_normalise #(
        .W(UNNORMALISED_WIDTH), .OW(NORMAL_WIDTH), .FRAC(NORMAL_FRAC), .KIND(NORMALISE_KIND),
        .INDEX_BITS(INVERSE_SQRT_INDEX_BITS), .NEWTON_STEPS(INVERSE_SQRT_NEWTON_STEPS),
        .BITS(INVERSE_SQRT_BITS), .L(L)
    ) unit (
        .clk(clk), .load(load), .x(x), .y(y), .z(z),
        .unit_x(unit_x), .unit_y(unit_y), .unit_z(unit_z)
    );
endmodule

`default_nettype wire
