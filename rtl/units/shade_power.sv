`default_nettype none

// s = x^n of a cosine, as 2^(n log2 x): leading-one detection and a ROM of log2(1 + u) in quadratic
// pieces, a product, a ROM of 2^-f in linear pieces, and a shift that rounds. Bit for bit the
// datapath's Power (datapath/numbers/power.cpp). Seven register stages.
//
// x <= 0 gives 0, x above one counts as one.
module shade_power #(
    parameter integer CW       = 18,  // bits of x and of the result
    parameter integer CF       = 16,  // of which fraction bits, 20 at most
    parameter integer LOG_BITS = 5,   // log2 of the logarithm's pieces, 1 to 5
    parameter integer EXP_BITS = 6    // log2 of the exponential's pieces, 1 to 8
) (
    input  wire                 clk,
    input  wire [6:0]           load,
    input  wire [7:0]           n,        // a register
    input  wire signed [CW-1:0] x,
    output wire signed [CW-1:0] power
);
    localparam integer FRAC   = 20;                // of u, of logarithms, of f and of the mantissa
    localparam integer LOG_N  = 1 << LOG_BITS;
    localparam integer LOG_M  = FRAC - LOG_BITS;   // bits of t in a piece of the logarithm
    // Fraction bits of the logarithm's ROM: its rounding stays below the interpolation's error.
    localparam integer KNOT   = (3 * LOG_BITS + 8 < FRAC) ? 3 * LOG_BITS + 8 : FRAC;
    localparam integer RISE   = KNOT - LOG_BITS + 1;
    localparam integer BEND   = KNOT - 2 * LOG_BITS;
    localparam integer LOG_WORD = KNOT + RISE + BEND;          // {knot, rise, bend}
    localparam integer SUM    = KNOT + LOG_M + 1;
    localparam integer EXP_N  = 1 << EXP_BITS;
    localparam integer EXP_M  = FRAC - EXP_BITS;
    localparam integer EXP_WORD = (FRAC + 1) + EXP_M;          // {knot, fall}

`include "rtl/units/shade_tables.svh"

    initial if (LOG_BITS < 1 || LOG_BITS > 5 || EXP_BITS < 1 || EXP_BITS > 8 || CF > 20)
        $fatal(1, "shade_power: LOG_BITS 1 to 5, EXP_BITS 1 to 8, CF at most 20");

    reg [LOG_WORD-1:0] log_rom [0:LOG_N-1];
    reg [EXP_WORD-1:0] exp_rom [0:EXP_N-1];
    integer            i, j;
    initial for (i = 0; i < LOG_N; i = i + 1) log_rom[i] = LOG_TABLE[i*LOG_WORD +: LOG_WORD];
    initial for (j = 0; j < EXP_N; j = j + 1) exp_rom[j] = EXP_TABLE[j*EXP_WORD +: EXP_WORD];

    function automatic [4:0] leading_one(input [31:0] v);
        integer k;
        leading_one = 5'd0;
        for (k = 0; k < 32; k = k + 1) if (v[k]) leading_one = 5'(k);
    endfunction

    // Stage 0: the leading one's place, and what follows it, of which nothing is dropped.
    localparam integer XW = CW + 1;
    localparam signed [XW-1:0] ONE = XW'(1) <<< CF;

    wire signed [XW-1:0] wide = XW'(x);
    wire [31:0]        padded = (wide < 0) ? 32'd0 : (wide > ONE) ? 32'(ONE) : 32'(wide);
    wire [4:0]         place  = leading_one(padded);
    wire [31:0]        top    = padded << (5'd31 - place);
    reg                zero0, zero1, zero2, zero3, zero4;
    reg  [4:0]         place0, place1;
    reg  [FRAC-1:0]    u0;
    wire               unused_low = &{1'b0, top[31], top[30-FRAC:0]};

    always_ff @(posedge clk) begin
        if (load[0]) begin
            zero0  <= (padded == 32'd0);
            place0 <= place;
            u0     <= top[30 -: FRAC];
        end
    end

    // Stage 1: the piece, and t (1 - t) cut to the bits of t.
    wire [LOG_M-1:0]    t0      = u0[LOG_M-1:0];
    wire [LOG_M:0]      rest    = (LOG_M+1)'(1 << LOG_M) - (LOG_M+1)'(t0);
    wire [2*LOG_M:0]    product = (2*LOG_M+1)'(t0) * (2*LOG_M+1)'(rest);
    reg  [LOG_WORD-1:0] piece;
    reg  [LOG_M-1:0]    t1, arch;
    wire                unused_product = &{1'b0, product[2*LOG_M], product[LOG_M-1:0]};

    always_ff @(posedge clk) begin
        if (load[1]) begin
            zero1  <= zero0;
            place1 <= place0;
            piece  <= log_rom[u0[FRAC-1 -: LOG_BITS]];
            t1     <= t0;
            arch   <= product[2*LOG_M-1 -: LOG_M];
        end
    end

    // Stage 2: -log2 of the cosine, u5.20; never negative.
    wire [KNOT-1:0] knot = piece[LOG_WORD-1 -: KNOT];
    wire [RISE-1:0] rise = piece[BEND +: RISE];
    wire [SUM-1:0]  sum  = (SUM'(knot) << LOG_M) + SUM'(rise) * SUM'(t1)
                         + SUM'(piece[BEND-1:0]) * SUM'(arch);
    wire [FRAC+4:0] log  = {place1, {FRAC{1'b0}}} + (FRAC+5)'(sum >> (KNOT + LOG_M - FRAC));
    reg  [FRAC+4:0] depth;

    always_ff @(posedge clk) begin
        if (load[2]) begin
            zero2 <= zero1;
            depth <= {5'(CF), {FRAC{1'b0}}} - log;
        end
    end

    // Stage 3: times n.
    reg [FRAC+12:0] total;

    always_ff @(posedge clk) begin
        if (load[3]) begin
            zero3 <= zero2;
            total <= (FRAC+13)'(depth) * (FRAC+13)'(n);
        end
    end

    // Stage 4: the piece of 2^-f. Results of 2^-44 and less are zero.
    wire [12:0]         octaves = total[FRAC +: 13];
    reg  [5:0]          shift4, shift5;
    reg  [EXP_WORD-1:0] exp_piece;
    reg  [EXP_M-1:0]    t4;

    always_ff @(posedge clk) begin
        if (load[4]) begin
            zero4     <= zero3 | (octaves > 13'd43);
            shift4    <= octaves[5:0];
            exp_piece <= exp_rom[total[FRAC-1 -: EXP_BITS]];
            t4        <= total[EXP_M-1:0];
        end
    end

    // Stage 5: the mantissa, floored.
    localparam integer EW = FRAC + 1 + EXP_M;
    wire [FRAC:0]    exp_knot = exp_piece[EXP_WORD-1 -: FRAC+1];
    wire [EXP_M-1:0] fall     = exp_piece[EXP_M-1:0];
    wire [EW-1:0]    fine     = (EW'(exp_knot) << EXP_M) - EW'(fall) * EW'(t4);
    reg  [FRAC:0]    mantissa;
    wire             unused_fine = &{1'b0, fine[EXP_M-1:0]};

    always_ff @(posedge clk) begin
        if (load[5]) begin
            mantissa <= zero4 ? '0 : fine[EW-1 -: FRAC+1];
            shift5   <= zero4 ? 6'd43 : shift4;
        end
    end

    // Stage 6: shifted and rounded to a cosine's fraction bits.
    wire signed [CW-1:0] rounded;
    reg  signed [CW-1:0] result;

    rp_scaled_cast #(.W(FRAC + 2), .LEAST(FRAC), .MOST(63), .OFFSET(-CF), .OW(CW)) to_cosine (
        .x({1'b0, mantissa}), .exponent(6'(FRAC) + shift5), .y(rounded)
    );

    always_ff @(posedge clk) if (load[6]) result <= rounded;

    assign power = result;
endmodule

`default_nettype wire
