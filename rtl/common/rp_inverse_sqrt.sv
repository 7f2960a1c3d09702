`default_nettype none

// 1/sqrt(x) of a positive integer in twelve register stages: leading-zero count, shift, a ROM of
// seeds, up to two Newton steps, rounding. 1/sqrt(x) = mantissa * 2^-exponent, with the mantissa's
// top bit set. Bit for bit the datapath's InverseSqrt (datapath/numbers/functions.cpp); x = 0 gives
// whatever.
//
// No handshake of its own: it is part of a unit's pipeline, whose `load` bits enable its stages.
// x is taken with load[0]; the result stands behind stage 11. A step that NEWTON_STEPS leaves out
// is four plain registers, so that the latency does not depend on it.
//
// D = d * 2^-32 is x normalised to [1/4, 1) by an even shift; Y = y * 2^-31 approximates
// 1/sqrt(D), within [1, 2).
module rp_inverse_sqrt #(
    parameter integer W            = 38,  // bits of x, at most 62
    parameter integer INDEX_BITS   = 7,   // log2 of the number of seeds, 2 to 12
    parameter integer NEWTON_STEPS = 2,   // 0 to 2
    parameter integer BITS         = 24   // of the mantissa, at most 29
) (
    input  wire            clk,
    input  wire [11:0]     load,      // stage enables, of the unit's rp_pipe
    input  wire [W-1:0]    x,
    output wire [BITS-1:0] mantissa,
    output wire [5:0]      exponent   // BITS - 1 (x = 1) to BITS + (W - 1) / 2
);
    localparam integer SEEDS     = 1 << INDEX_BITS;
    localparam integer HALF      = SEEDS / 2;
    localparam integer SEED_FRAC = INDEX_BITS + 3;  // rounding is an eighth of the interval's error
    localparam integer DROPPED   = 32 - BITS;       // of y's fraction bits, at least 3
    localparam integer P         = (W <= 32) ? 32 : W + W % 2;  // even, as every shift is

    initial if (W > 62 || INDEX_BITS < 2 || INDEX_BITS > 12 || NEWTON_STEPS > 2 || BITS > 29)
        $fatal(1, "rp_inverse_sqrt: W <= 62, 2 <= INDEX_BITS <= 12, NEWTON_STEPS <= 2, BITS <= 29");

    // The seed of entry i: 1/sqrt of the middle of its interval of D, to nearest. The first half
    // of the table is for D in [1/4, 1/2), the second for [1/2, 1). The root is found bit by bit,
    // once more precise than the seed.
    function automatic [INDEX_BITS+3:0] seed(input integer i);
        reg [63:0] square, root, trial;
        integer    odd, bit_of_root;
        begin
            odd    = 2 * (HALF + i % HALF) + 1;
            square = (64'd1 << (2 * SEED_FRAC + INDEX_BITS + 4 - ((i >= HALF) ? 1 : 0)))
                   / 64'(odd);
            root   = 64'd0;
            for (bit_of_root = 23; bit_of_root >= 0; bit_of_root = bit_of_root - 1) begin
                trial = root | (64'd1 << bit_of_root);
                if (trial * trial <= square) root = trial;
            end
            seed = (INDEX_BITS+4)'((root + 64'd1) >> 1);
        end
    endfunction

    reg [INDEX_BITS+3:0] seeds [0:SEEDS-1];
    integer              i;
    initial for (i = 0; i < SEEDS; i = i + 1) seeds[i] = seed(i);

    // The number of zeros above the leading one, made even: P for v = 0.
    function automatic [5:0] even_zeros(input [P-1:0] v);
        integer k;
        even_zeros = 6'(P);
        for (k = 0; k < P; k = k + 1) if (v[k]) even_zeros = 6'((P - 1 - k) / 2 * 2);
    endfunction

    // Stages 0 and 1: normalise.
    wire [P-1:0] padded  = P'(x);
    reg  [P-1:0] x0;
    reg  [5:0]   zeros0;
    wire [P-1:0] shifted = x0 << zeros0;
    reg  [31:0]  d1;
    reg  [5:0]   e1;                    // the exponent, before rounding can lessen it

    always_ff @(posedge clk) begin
        if (load[0]) begin
            x0     <= padded;
            zeros0 <= even_zeros(padded);
        end
        if (load[1]) begin
            d1 <= shifted[P-1 -: 32];
            e1 <= 6'(BITS + P / 2 - 1) - (zeros0 >> 1);
        end
    end

    generate
        if (P > 32) begin : g_cut
            wire unused_low = &{1'b0, shifted[P-33:0]};
        end
    endgenerate

    // Stage 2: the seed. Its index is d's leading bits below those that say which octave D is in.
    wire [INDEX_BITS-1:0] index = d1[31] ? {1'b1, d1[30 -: INDEX_BITS-1]}
                                         : {1'b0, d1[29 -: INDEX_BITS-1]};
    reg [31:0] d2, y2;
    reg [5:0]  e2;

    always_ff @(posedge clk) begin
        if (load[2]) begin
            d2 <= d1;
            e2 <= e1;
            y2 <= 32'(seeds[index]) << (31 - SEED_FRAC);
        end
    end

    // Stages 3 to 10: Newton, twice.
    wire [31:0] d6, y6, d10, y10;
    wire [5:0]  e6, e10;
    wire        unused_d = &{1'b0, d10};

    rp_sqrt_newton #(.ACTIVE(NEWTON_STEPS > 0 ? 1 : 0)) first (
        .clk(clk), .load(load[6:3]),
        .in_d(d2), .in_y(y2), .in_e(e2), .out_d(d6), .out_y(y6), .out_e(e6)
    );
    rp_sqrt_newton #(.ACTIVE(NEWTON_STEPS > 1 ? 1 : 0)) second (
        .clk(clk), .load(load[10:7]),
        .in_d(d6), .in_y(y6), .in_e(e6), .out_d(d10), .out_y(y10), .out_e(e10)
    );

    // Stage 11: to BITS bits; a value just below 2 is carried to 2^BITS, a bit too long.
    wire [32:0]   half_up = {1'b0, y10} + (33'd1 << (DROPPED - 1));
    wire [BITS:0] nearest = (BITS+1)'(half_up >> DROPPED);
    wire          carry   = nearest[BITS];
    reg [BITS-1:0] result;
    reg [5:0]      e11;

    always_ff @(posedge clk) begin
        if (load[11]) begin
            result <= carry ? nearest[BITS:1] : nearest[BITS-1:0];
            e11    <= e10 - 6'(carry);
        end
    end

    assign mantissa = result;
    assign exponent = e11;
endmodule

`default_nettype wire
