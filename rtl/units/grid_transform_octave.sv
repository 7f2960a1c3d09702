`default_nettype none

// z_grid = K (log2(w) - log2(near)): leading-zero count, and a ROM of log2(1 + u) over one octave,
// interpolated in 2^INDEX_BITS pieces. Bit for bit the datapath's OctaveLog2
// (datapath/numbers/log2.cpp), monotone in w. Six register stages, enabled by the unit's `load`.
//
// A piece is knot + rise t, or knot + rise t + bend t (1 - t), 0 <= t < 1.
module grid_transform_octave #(
    parameter integer CW         = 32,  // bits of w
    parameter integer CLIP_FRAC  = 16,  // of which fraction bits
    parameter integer QUADRATIC  = 0,   // 1: pieces have a bend
    parameter integer INDEX_BITS = 6,   // linear: 1 to 8, quadratic: 1 to 5
    parameter integer KW         = 24,  // bits of K
    parameter integer K_FRAC     = 11   // of which fraction bits
) (
    input  wire                 clk,
    input  wire [5:0]           load,
    input  wire [KW-1:0]        steps_per_octave,  // K
    input  wire signed [26:0]   log2_near,         // s6.20
    input  wire signed [CW-1:0] w,                 // > 0
    output wire signed [21:0]   z                  // s15.6
);
    localparam integer MANTISSA  = 20;             // bits of u; what lies below is dropped
    localparam integer LOG_FRAC  = 20;
    localparam integer N         = 1 << INDEX_BITS;
    localparam integer M         = MANTISSA - INDEX_BITS;  // bits of t
    // Fraction bits of the table: its rounding stays below the interpolation's error.
    localparam integer WANTED    = (QUADRATIC != 0) ? 3 * INDEX_BITS + 8 : 2 * INDEX_BITS + 5;
    localparam integer FRAC      = (WANTED < LOG_FRAC) ? WANTED : LOG_FRAC;
    localparam integer RISE      = FRAC - INDEX_BITS + 1;
    localparam integer BEND      = (QUADRATIC != 0) ? FRAC - 2 * INDEX_BITS : 1;
    localparam integer SUM       = FRAC + M + 1;           // up to 1 + the first knot: one integer bit

    // Words of {knot, rise} or {knot, rise, bend}, word 0 in the low bits of TABLE.
    localparam integer WORD = FRAC + RISE + ((QUADRATIC != 0) ? BEND : 0);

`include "rtl/units/grid_transform_tables.svh"

    initial if (INDEX_BITS < 1 || INDEX_BITS > ((QUADRATIC != 0) ? 5 : 8))
        $fatal(1, "grid_transform: INDEX_BITS must be 1 to 8, with quadratic pieces 1 to 5");

    reg [WORD-1:0] rom [0:N-1];
    integer        i;
    initial for (i = 0; i < N; i = i + 1) rom[i] = TABLE[i*WORD +: WORD];

    // Stage 0: the leading one's place, and what follows it.
    function automatic [4:0] leading_one(input [31:0] v);
        integer k;
        leading_one = 5'd0;
        for (k = 0; k < 32; k = k + 1) if (v[k]) leading_one = 5'(k);
    endfunction

    wire [31:0] padded = 32'(w);
    wire [4:0]  place  = leading_one(padded);
    wire [31:0] top    = padded << (5'd31 - place);        // the leading one in bit 31
    reg  [4:0]  exponent0;
    reg  [MANTISSA-1:0] u0;
    wire        unused_low = &{1'b0, top[31], top[30-MANTISSA:0]};

    always_ff @(posedge clk) begin
        if (load[0]) begin
            exponent0 <= place;
            u0        <= top[30 -: MANTISSA];
        end
    end

    // Stage 1: the piece, and t (1 - t) cut to M bits.
    wire [M-1:0]    t0 = u0[M-1:0];
    reg  [4:0]      exponent1;
    reg  [WORD-1:0] piece;
    reg  [M-1:0]    t1;

    always_ff @(posedge clk) begin
        if (load[1]) begin
            exponent1 <= exponent0;
            piece     <= rom[u0[MANTISSA-1 -: INDEX_BITS]];
            t1        <= t0;
        end
    end

    // Stage 2: the sum, with FRAC + M fraction bits, floored to LOG_FRAC.
    wire [FRAC-1:0] knot   = piece[WORD-1 -: FRAC];
    wire [RISE-1:0] rise   = piece[WORD-FRAC-1 -: RISE];
    wire [SUM-1:0]  linear = (SUM'(knot) << M) + SUM'(rise) * SUM'(t1);
    wire [SUM-1:0]  sum;
    reg  [LOG_FRAC+5:0] log;                               // u6.20
    wire            unused_sum = &{1'b0, sum[FRAC+M-LOG_FRAC-1:0]};

    generate
        if (QUADRATIC != 0) begin : g_bend
            wire [M:0]   rest    = (M+1)'(1 << M) - (M+1)'(t0);
            wire [2*M:0] product = (2*M+1)'(t0) * (2*M+1)'(rest);
            reg  [M-1:0] arch;
            wire         unused_product = &{1'b0, product[2*M], product[M-1:0]};

            always_ff @(posedge clk) if (load[1]) arch <= product[2*M-1 -: M];

            assign sum = linear + SUM'(piece[BEND-1:0]) * SUM'(arch);
        end else begin : g_straight
            assign sum = linear;
        end
    endgenerate

    always_ff @(posedge clk)
        if (load[2]) log <= {1'b0, exponent1, {LOG_FRAC{1'b0}}} + (LOG_FRAC+6)'(sum >> (FRAC + M - LOG_FRAC));

    // Stage 3: in octaves from near; both logarithms lie within -64 .. 64.
    localparam signed [27:0] POINT = 28'(CLIP_FRAC) <<< LOG_FRAC;
    reg signed [27:0] octaves;

    always_ff @(posedge clk)
        if (load[3]) octaves <= $signed({2'b00, log}) - POINT - 28'(log2_near);

    // Stages 4 and 5: times K, to the grid.
    localparam integer PW = KW + 29;
    reg signed [PW-1:0] steps;
    wire signed [21:0]  rounded;
    reg signed [21:0]   z5;

    rp_cast #(.W(PW), .SHIFT(K_FRAC + LOG_FRAC - 6), .OW(22)) to_grid (.x(steps), .y(rounded));

    always_ff @(posedge clk) begin
        if (load[4]) steps <= $signed(PW'(steps_per_octave)) * PW'(octaves);
        if (load[5]) z5    <= rounded;
    end

    assign z = z5;
endmodule

`default_nettype wire
