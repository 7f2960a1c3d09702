`default_nettype none

// Perspective correction (Gumhold and Huettner 3.1): the components of a vertex were interpolated
// as v * c with c = w_scale / w; here v = (v * c) / c. Normal and tangent leave on their way into
// the unit `normalise`.
//
// Stages 0 to 7: 1/c, a c that is not positive being taken as the least positive one. Stage 8: a
// product a component. Stage 9: shift, round half up, saturate.
//
// With fewer than 13 COMPONENTS there are no tangents: those inputs are not used.
//
// Time: latency 10, one vertex a cycle, in_ready follows out_ready.
module perspective #(
`include "rtl/units/perspective_params.svh"
) (
    input  wire                                 clk,
    input  wire                                 rst_n,         // synchronous, low

    // A register, stable while vertices are in the unit.
    input  wire                                 tangents,      // vertices have tangents

    input  wire                                 in_valid,
    output wire                                 in_ready,
    input  wire signed [SWEEP_DATA_WIDTH-1:0]   x_c,           // position, times c
    input  wire signed [SWEEP_DATA_WIDTH-1:0]   y_c,
    input  wire signed [SWEEP_DATA_WIDTH-1:0]   z_c,
    input  wire signed [SWEEP_DATA_WIDTH-1:0]   nx_c,          // normal
    input  wire signed [SWEEP_DATA_WIDTH-1:0]   ny_c,
    input  wire signed [SWEEP_DATA_WIDTH-1:0]   nz_c,
    input  wire signed [SWEEP_DATA_WIDTH-1:0]   uv_x_c,        // texture coordinates
    input  wire signed [SWEEP_DATA_WIDTH-1:0]   uv_y_c,
    input  wire signed [INVERSE_W_WIDTH-1:0]    c,
    input  wire signed [SWEEP_DATA_WIDTH-1:0]   tx_c,          // tangent
    input  wire signed [SWEEP_DATA_WIDTH-1:0]   ty_c,
    input  wire signed [SWEEP_DATA_WIDTH-1:0]   tz_c,
    input  wire signed [SWEEP_DATA_WIDTH-1:0]   handedness_c,  // its sign

    output wire                                 out_valid,
    input  wire                                 out_ready,
    output wire signed [POSITION_WIDTH-1:0]     x,
    output wire signed [POSITION_WIDTH-1:0]     y,
    output wire signed [POSITION_WIDTH-1:0]     z,
    output wire signed [UNNORMALISED_WIDTH-1:0] nx,
    output wire signed [UNNORMALISED_WIDTH-1:0] ny,
    output wire signed [UNNORMALISED_WIDTH-1:0] nz,
    output wire signed [UV_WIDTH-1:0]           uv_x,
    output wire signed [UV_WIDTH-1:0]           uv_y,
    output wire signed [UNNORMALISED_WIDTH-1:0] tx,
    output wire signed [UNNORMALISED_WIDTH-1:0] ty,
    output wire signed [UNNORMALISED_WIDTH-1:0] tz,
    output wire                                 left_handed,
    output wire                                 clamped        // c was not positive
);
    localparam integer DW = SWEEP_DATA_WIDTH;
    localparam integer XW = INVERSE_W_WIDTH - 1;    // a positive c without its sign
    localparam integer FRAC_C = SWEEP_DATA_FRAC - INVERSE_W_FRAC;  // fraction bits of v*c over c

    // Components in the order of the ports, without c and handedness.
    localparam integer HAS_TANGENTS = (COMPONENTS > 9) ? 1 : 0;
    localparam integer N = (HAS_TANGENTS != 0) ? 11 : 8;

    wire            with_tangents = tangents & (HAS_TANGENTS != 0);
    wire            not_positive  = (c <= 0);
    wire [XW-1:0]   divisor       = not_positive ? XW'(1) : c[XW-1:0];
    wire [N*DW-1:0] components;

    generate
        if (HAS_TANGENTS != 0) begin : g_tangents
            // Zero in, zero out.
            assign components = {{3*DW{with_tangents}} & {tz_c, ty_c, tx_c},
                                 uv_y_c, uv_x_c, nz_c, ny_c, nx_c, z_c, y_c, x_c};
        end else begin : g_plain
            wire unused_tangent = &{1'b0, tx_c, ty_c, tz_c};
            assign components = {uv_y_c, uv_x_c, nz_c, ny_c, nx_c, z_c, y_c, x_c};
        end
    endgenerate

    wire [9:0] load;
    wire       unused_magnitude = &{1'b0, handedness_c};

    rp_pipe #(.W(2), .L(10)) stages (
        .clk      (clk),
        .rst_n    (rst_n),
        .in_valid (in_valid),
        .in_ready (in_ready),
        .in_data  ({with_tangents & handedness_c[DW-1], not_positive}),
        .out_valid(out_valid),
        .out_ready(out_ready),
        .out_data ({left_handed, clamped}),
        .load     (load)
    );

    // Stages 0 to 7.
    wire [RECIPROCAL_BITS-1:0] mantissa;
    wire [5:0]                 exponent;
    wire [N*DW-1:0]            waited;

    rp_reciprocal #(
        .W(XW), .INDEX_BITS(RECIPROCAL_INDEX_BITS), .NEWTON_STEPS(RECIPROCAL_NEWTON_STEPS),
        .BITS(RECIPROCAL_BITS)
    ) reciprocal (
        .clk(clk), .load(load[7:0]), .x(divisor), .mantissa(mantissa), .exponent(exponent)
    );
    rp_delay #(.W(N*DW), .L(8)) delay (
        .clk(clk), .load(load[7:0]), .in_data(components), .out_data(waited)
    );

    // Stages 8 and 9.
    wire [3*POSITION_WIDTH-1:0]     positions;
    wire [6*UNNORMALISED_WIDTH-1:0] vectors;       // normal, tangent
    wire [2*UV_WIDTH-1:0]           coordinates;

    genvar k;
    generate
        for (k = 0; k < 3; k = k + 1) begin : g_position
            perspective_component #(
                .DW(DW), .BITS(RECIPROCAL_BITS), .OFFSET(FRAC_C - POSITION_FRAC),
                .OW(POSITION_WIDTH)
            ) quotient (
                .clk(clk), .load(load[9:8]), .value(waited[k*DW +: DW]),
                .mantissa(mantissa), .exponent(exponent),
                .result(positions[k*POSITION_WIDTH +: POSITION_WIDTH])
            );
        end
        for (k = 0; k < 3; k = k + 1) begin : g_normal
            perspective_component #(
                .DW(DW), .BITS(RECIPROCAL_BITS), .OFFSET(FRAC_C - UNNORMALISED_FRAC),
                .OW(UNNORMALISED_WIDTH)
            ) quotient (
                .clk(clk), .load(load[9:8]), .value(waited[(3+k)*DW +: DW]),
                .mantissa(mantissa), .exponent(exponent),
                .result(vectors[k*UNNORMALISED_WIDTH +: UNNORMALISED_WIDTH])
            );
        end
        for (k = 0; k < 2; k = k + 1) begin : g_coordinate
            perspective_component #(
                .DW(DW), .BITS(RECIPROCAL_BITS), .OFFSET(FRAC_C - UV_FRAC), .OW(UV_WIDTH)
            ) quotient (
                .clk(clk), .load(load[9:8]), .value(waited[(6+k)*DW +: DW]),
                .mantissa(mantissa), .exponent(exponent),
                .result(coordinates[k*UV_WIDTH +: UV_WIDTH])
            );
        end
        for (k = 8; k < N; k = k + 1) begin : g_tangent
            perspective_component #(
                .DW(DW), .BITS(RECIPROCAL_BITS), .OFFSET(FRAC_C - UNNORMALISED_FRAC),
                .OW(UNNORMALISED_WIDTH)
            ) quotient (
                .clk(clk), .load(load[9:8]), .value(waited[k*DW +: DW]),
                .mantissa(mantissa), .exponent(exponent),
                .result(vectors[(k-5)*UNNORMALISED_WIDTH +: UNNORMALISED_WIDTH])
            );
        end
        if (HAS_TANGENTS == 0) begin : g_none
            assign vectors[6*UNNORMALISED_WIDTH-1:3*UNNORMALISED_WIDTH] = '0;
        end
    endgenerate

    assign {z, y, x}                = positions;
    assign {tz, ty, tx, nz, ny, nx} = vectors;
    assign {uv_y, uv_x}             = coordinates;
endmodule

`default_nettype wire
