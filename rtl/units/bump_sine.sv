`default_nettype none

// The sine or cosine of an angle in half turns, of any number of turns: a ROM of a quarter wave in
// linear pieces, rounded half up. Bit for bit the datapath's Sine (datapath/numbers/sine.cpp) and
// its cast.
//
// Stage 0: the place in the quarter wave. Stage 1: the piece. Stage 2: the value.
module bump_sine #(
    parameter integer AW         = 16,  // bits of the angle
    parameter integer AFRAC      = 15,  // of which fraction bits, 1 to 16
    parameter integer INDEX_BITS = 6,   // log2 of the pieces, 2 to 10
    parameter integer COSINE     = 0,
    parameter integer OW         = 16,  // bits of the result
    parameter integer OFRAC      = 14   // of which fraction bits
) (
    input  wire                 clk,
    input  wire [2:0]           load,
    input  wire signed [AW-1:0] angle,
    output reg  signed [OW-1:0] value
);
    localparam integer FRAC   = 20;                // of knots
    localparam integer KW     = FRAC + 1;          // of a knot, 0 to 1
    localparam integer MOST   = 10;                // log2 of the printed table's pieces
    localparam integer PIECES = 1 << INDEX_BITS;
    localparam integer PHASE  = AFRAC + 1;         // bits of an angle within a turn
    localparam integer XW     = (AW > PHASE) ? AW : PHASE;
    localparam integer RW     = PHASE + INDEX_BITS;
    localparam integer TW     = KW + PHASE;        // of a rise times its part

    localparam [PHASE-1:0] QUARTER = PHASE'(1) << (AFRAC - 1);

`include "rtl/units/bump_tables.svh"

    initial if (INDEX_BITS < 2 || INDEX_BITS > MOST || AFRAC < 1 || AFRAC > 16)
        $fatal(1, "bump_sine: INDEX_BITS 2 to 10, AFRAC 1 to 16");

    // A smaller table has every 2^n-th of the printed knots. Behind the last one nothing rises.
    reg [KW-1:0] knots [0:PIECES];
    reg [KW-1:0] rises [0:PIECES];
    integer      i;
    initial begin
        for (i = 0; i <= PIECES; i = i + 1)
            knots[i] = SINE_KNOTS[(i << (MOST - INDEX_BITS))*KW +: KW];
        for (i = 0; i < PIECES; i = i + 1)
            rises[i] = SINE_KNOTS[((i + 1) << (MOST - INDEX_BITS))*KW +: KW]
                     - SINE_KNOTS[(i << (MOST - INDEX_BITS))*KW +: KW];
        rises[PIECES] = '0;
    end

    wire signed [XW-1:0] wide       = XW'(angle);
    wire [PHASE-1:0]     phase      = wide[PHASE-1:0] + ((COSINE != 0) ? QUARTER : PHASE'(0));
    wire [PHASE-1:0]     from_start = phase & (QUARTER - PHASE'(1));
    wire                 unused_turns = &{1'b0, wide};

    reg  [PHASE-1:0]     place;                    // 0 to a quarter turn
    reg                  negative_0, negative_1;
    wire [RW-1:0]        raised = RW'(place) << INDEX_BITS;
    wire [RW-1:0]        index  = raised >> (AFRAC - 1);
    reg  [KW-1:0]        knot, rise;
    reg  [PHASE-1:0]     part;                     // of the piece

    wire [TW-1:0]        risen  = (TW'(rise) * TW'(part) + (TW'(QUARTER) >> 1)) >> (AFRAC - 1);
    wire [KW:0]          sum    = (KW+1)'(knot) + risen[KW:0];
    wire signed [KW:0]   signed_sum = negative_1 ? -$signed(sum) : $signed(sum);
    wire signed [OW-1:0] fitted;
    wire                 unused_top = &{1'b0, index, risen[TW-1:KW+1]};

    rp_cast #(.W(KW + 1), .SHIFT(FRAC - OFRAC), .OW(OW)) cast (.x(signed_sum), .y(fitted));

    always_ff @(posedge clk) begin
        if (load[0]) begin
            place      <= phase[AFRAC-1] ? QUARTER - from_start : from_start;
            negative_0 <= phase[AFRAC];
        end
        if (load[1]) begin
            knot       <= knots[index[INDEX_BITS:0]];
            rise       <= rises[index[INDEX_BITS:0]];
            part       <= raised[PHASE-1:0] & (QUARTER - PHASE'(1));
            negative_1 <= negative_0;
        end
        if (load[2]) value <= fitted;
    end
endmodule

`default_nettype wire
