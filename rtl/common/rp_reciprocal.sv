`default_nettype none

// 1/x of a positive integer in eight register stages: leading-zero count, a ROM of seeds, up to two
// Newton steps, and one exact correction. 1/x = mantissa * 2^-exponent, with the mantissa's top bit
// set. Bit for bit the datapath's Reciprocal (datapath/numbers/functions.cpp); x = 0 gives the
// largest mantissa with the exponent of x = 1.
//
// No handshake of its own: it is part of a unit's pipeline, whose `load` bits enable its stages.
// x is taken with load[0]; the result stands behind stage 7. A step that NEWTON_STEPS leaves out
// is two plain registers, so that the latency does not depend on the profile.
//
// D = d * 2^-32 is x normalised to [1/2, 1); Y = y * 2^-31 approximates 1/D, within [1, 2].
module rp_reciprocal #(
    parameter integer W            = 32,  // bits of x, at most 32
    parameter integer INDEX_BITS   = 7,   // log2 of the number of seeds, at most 12
    parameter integer NEWTON_STEPS = 2,   // 0 to 2
    parameter integer BITS         = 24   // of the mantissa, at most 30
) (
    input  wire            clk,
    input  wire [7:0]      load,      // stage enables, of the unit's rp_pipe
    input  wire [W-1:0]    x,
    output wire [BITS-1:0] mantissa,
    output wire [5:0]      exponent   // BITS - 1 (x = 1) to BITS + 30
);
    localparam integer SEEDS     = 1 << INDEX_BITS;
    localparam integer SEED_FRAC = INDEX_BITS + 3;   // rounding is an eighth of the interval's error
    localparam integer DROPPED   = 32 - BITS;        // of y's fraction bits, at least 2

    initial if (W > 32 || NEWTON_STEPS > 2 || BITS > 30 || INDEX_BITS > 12)
        $fatal(1, "rp_reciprocal: W <= 32, INDEX_BITS <= 12, NEWTON_STEPS <= 2, BITS <= 30");

    // The reciprocal of the middle of each interval of D, to nearest; its leading one included.
    reg [INDEX_BITS+3:0] seeds [0:SEEDS-1];
    integer              i;
    initial for (i = 0; i < SEEDS; i = i + 1)
        seeds[i] = (INDEX_BITS+4)'(((1 << (SEED_FRAC + INDEX_BITS + 2)) + SEEDS + i)
                                   / (2 * (SEEDS + i) + 1));

    // The number of zeros above the leading one: 32 for v = 0.
    function automatic [5:0] leading_zeros(input [31:0] v);
        integer k;
        leading_zeros = 6'd32;
        for (k = 0; k < 32; k = k + 1) if (v[k]) leading_zeros = 6'(31 - k);
    endfunction

    // Stage 0: normalise.
    wire [31:0] padded = 32'(x);
    wire [5:0]  zeros  = leading_zeros(padded);

    reg [31:0] d0, d1;
    reg [5:0]  e0, e1;                 // the exponent
    reg [32:0] y1;

    always_ff @(posedge clk) begin
        if (load[0]) begin
            d0 <= padded << zeros;
            e0 <= 6'(31 + BITS) - zeros;
        end
    end

    // Stage 1: the seed.
    always_ff @(posedge clk) begin
        if (load[1]) begin
            d1 <= d0;
            e1 <= e0;
            y1 <= 33'(seeds[d0[30 -: INDEX_BITS]]) << (31 - SEED_FRAC);
        end
    end

    // Stages 2 to 5: Newton, twice.
    wire [31:0] d3, d5;
    wire [5:0]  e3, e5;
    wire [32:0] y3, y5;

    rp_newton #(.ACTIVE(NEWTON_STEPS > 0 ? 1 : 0)) first (
        .clk(clk), .load(load[3:2]),
        .in_d(d1), .in_y(y1), .in_e(e1), .out_d(d3), .out_y(y3), .out_e(e3)
    );
    rp_newton #(.ACTIVE(NEWTON_STEPS > 1 ? 1 : 0)) second (
        .clk(clk), .load(load[5:4]),
        .in_d(d3), .in_y(y3), .in_e(e3), .out_d(d5), .out_y(y5), .out_e(e5)
    );

    // Stage 6: q = Y to BITS fraction bits, at most 2^BITS, and twice the exact remainder.
    wire [33:0]        half_up = {1'b0, y5} + (34'd1 << (DROPPED - 1));
    wire [BITS:0]      rounded = (BITS+1)'(half_up >> DROPPED);
    wire signed [65:0] exact   = 66'sd1 <<< (32 + BITS);
    reg  [31:0]        d6;
    reg  [5:0]         e6;
    reg  [BITS:0]      q;
    reg  signed [65:0] twice_remainder;

    always_ff @(posedge clk) begin
        if (load[6]) begin
            d6              <= d5;
            e6              <= e5;
            q               <= rounded;
            twice_remainder <= exact - $signed(66'({rounded, 1'b0}) * 66'(d5));
        end
    end

    // Stage 7: one unit up or down to nearest, and the carry of 2^BITS. Only x = 0 leaves D's top
    // bit 0.
    wire signed [65:0] divisor = $signed(66'(d6));
    wire [BITS:0]      nearest = q + (BITS+1)'(twice_remainder > divisor)
                               - (BITS+1)'(twice_remainder < -divisor);
    wire               zero    = ~d6[31];
    wire               carry   = nearest[BITS] & ~zero;
    reg  [BITS-1:0]    result;
    reg  [5:0]         e7;

    always_ff @(posedge clk) begin
        if (load[7]) begin
            result <= zero ? '1 : carry ? nearest[BITS:1] : nearest[BITS-1:0];
            e7     <= e6 - 6'(carry);
        end
    end

    assign mantissa = result;
    assign exponent = e7;
endmodule

`default_nettype wire
