`default_nettype none

// v / |v| in L register stages, rounded half up: bit for bit the datapath's Normalise
// (datapath/numbers/policy.h). The zero vector stays zero.
//
// KIND 0: squares (1), their sum (1), the inverse square root (12), products (1), casts (1).
// KIND 1: CORDIC (3 N + 2 with N = FRAC + 5), casts (1).
//
// No handshake of its own: it is part of a unit's pipeline, whose `load` bits enable its stages;
// the unit's L must be the one below.
module rp_normalise #(
    parameter integer W            = 19,  // bits of x, y, z, at most 24
    parameter integer OW           = 16,  // bits of the result
    parameter integer FRAC         = 14,  // of which fraction bits
    parameter integer KIND         = 0,   // 0 inverse square root, 1 CORDIC
    parameter integer INDEX_BITS   = 7,   // of the inverse square root
    parameter integer NEWTON_STEPS = 2,
    parameter integer BITS         = 24,
    parameter integer L            = 16   // 16, or 3 (FRAC + 5) + 3 for CORDIC
) (
    input  wire                 clk,
    input  wire [L-1:0]         load,
    input  wire signed [W-1:0]  x,
    input  wire signed [W-1:0]  y,
    input  wire signed [W-1:0]  z,
    output reg  signed [OW-1:0] unit_x,
    output reg  signed [OW-1:0] unit_y,
    output reg  signed [OW-1:0] unit_z
);
    localparam integer BOUND = (FRAC < 4) ? 4 : (FRAC > 18) ? 18 : FRAC;
    localparam integer N     = BOUND + 5;

    initial if (L != ((KIND == 0) ? 16 : 3 * N + 3))
        $fatal(1, "rp_normalise: L does not fit KIND and FRAC");

    wire signed [OW-1:0] fit_x, fit_y, fit_z;

    always_ff @(posedge clk) begin
        if (load[L-1]) begin
            unit_x <= fit_x;
            unit_y <= fit_y;
            unit_z <= fit_z;
        end
    end

    generate
        if (KIND == 0) begin : g_inverse_sqrt
            localparam integer PW = W + BITS + 1;      // the mantissa becomes signed

            reg  [2*W-1:0]  xx, yy, zz;                // |min|^2 = 2^(2W-2)
            reg  [2*W-1:0]  square;                    // 3 * 2^(2W-2)
            wire [BITS-1:0] mantissa;
            wire [5:0]      exponent;
            wire [3*W-1:0]  waited;
            reg  signed [PW-1:0] px, py, pz;
            reg  [5:0]      shift;

            function automatic [2*W-1:0] squared(input signed [W-1:0] v);
                squared = (2*W)'(v) * (2*W)'(v);
            endfunction

            always_ff @(posedge clk) begin
                if (load[0]) begin
                    xx <= squared(x);
                    yy <= squared(y);
                    zz <= squared(z);
                end
                if (load[1]) square <= xx + yy + zz;
            end

            rp_inverse_sqrt #(
                .W(2 * W), .INDEX_BITS(INDEX_BITS), .NEWTON_STEPS(NEWTON_STEPS), .BITS(BITS)
            ) inverse_sqrt (
                .clk(clk), .load(load[13:2]), .x(square), .mantissa(mantissa), .exponent(exponent)
            );
            rp_delay #(.W(3 * W), .L(14)) delay (
                .clk(clk), .load(load[13:0]), .in_data({z, y, x}), .out_data(waited)
            );

            function automatic signed [PW-1:0] times(input signed [W-1:0] v,
                                                     input [BITS-1:0] m);
                times = PW'(v) * $signed(PW'(m));
            endfunction

            always_ff @(posedge clk) begin
                if (load[14]) begin
                    px    <= times($signed(waited[0*W +: W]), mantissa);
                    py    <= times($signed(waited[1*W +: W]), mantissa);
                    pz    <= times($signed(waited[2*W +: W]), mantissa);
                    shift <= exponent;
                end
            end

            rp_scaled_cast #(
                .W(PW), .LEAST(BITS - 1), .MOST(BITS + W), .OFFSET(-FRAC), .OW(OW)
            ) cast_x (.x(px), .exponent(shift), .y(fit_x));
            rp_scaled_cast #(
                .W(PW), .LEAST(BITS - 1), .MOST(BITS + W), .OFFSET(-FRAC), .OW(OW)
            ) cast_y (.x(py), .exponent(shift), .y(fit_y));
            rp_scaled_cast #(
                .W(PW), .LEAST(BITS - 1), .MOST(BITS + W), .OFFSET(-FRAC), .OW(OW)
            ) cast_z (.x(pz), .exponent(shift), .y(fit_z));
        end else begin : g_cordic
            localparam integer CW = N + 5;             // fraction bits in front of the cast

            wire signed [CW+3:0] wide_x, wide_y, wide_z;
            wire unused_sizes = (INDEX_BITS + NEWTON_STEPS + BITS) == 0;

            rp_cordic #(.W(W), .N(N), .BITS(CW)) cordic (
                .clk(clk), .load(load[L-2:0]), .x(x), .y(y), .z(z),
                .unit_x(wide_x), .unit_y(wide_y), .unit_z(wide_z)
            );
            rp_cast #(.W(CW + 4), .SHIFT(CW - FRAC), .OW(OW)) cast_x (.x(wide_x), .y(fit_x));
            rp_cast #(.W(CW + 4), .SHIFT(CW - FRAC), .OW(OW)) cast_y (.x(wide_y), .y(fit_y));
            rp_cast #(.W(CW + 4), .SHIFT(CW - FRAC), .OW(OW)) cast_z (.x(wide_z), .y(fit_z));
        end
    endgenerate
endmodule

`default_nettype wire
