`default_nettype none

// As rp_cast, for a shift that depends on the data: y = x * 2^-(exponent + OFFSET), SC_RND, SC_SAT.
// It brings a product with a reciprocal's mantissa (rp_reciprocal) into a format: for v in
// FV, c in FC and the result in FO fraction bits, v * (1/c) has OFFSET = FV - FC - FO.
module rp_scaled_cast #(
    parameter integer W      = 56,   // bits of x
    parameter integer LEAST  = 23,   // no exponent is below this
    parameter integer MOST   = 54,   // and none above this; at most 63
    parameter integer OFFSET = -22,  // added to the exponent; -LEAST - W at the least
    parameter integer OW     = 31    // bits of the result
) (
    input  wire signed [W-1:0]  x,
    input  wire [5:0]           exponent,
    output wire signed [OW-1:0] y
);
    // A constant shift to the left makes the variable one go right for every exponent.
    localparam integer LEFT  = (LEAST + OFFSET < 0) ? -(LEAST + OFFSET) : 0;
    localparam integer WIDE  = ((W + LEFT > OW) ? W + LEFT : OW) + 2;
    localparam integer START = LEFT + OFFSET;        // right shift = exponent + START >= 0

    initial if (MOST > 63 || LEAST + START < 0 || MOST + START > 127)
        $fatal(1, "rp_scaled_cast: the range of exponents does not fit");

    // One bit is kept below the result's last one: with it, half is added after the shift.
    wire [7:0]             right   = 8'(exponent) + 8'(START);
    wire signed [WIDE-1:0] wide    = WIDE'(x) <<< (LEFT + 1);
    wire signed [WIDE-1:0] floored = wide >>> right;
    wire signed [WIDE-1:0] rounded = (floored + WIDE'(1)) >>> 1;

    localparam signed [WIDE-1:0] HIGH = (WIDE'(1) <<< (OW - 1)) - WIDE'(1);

    assign y = (rounded > HIGH) ? {1'b0, {OW-1{1'b1}}}
             : (rounded < ~HIGH) ? {1'b1, {OW-1{1'b0}}}
             : rounded[OW-1:0];
endmodule

`default_nettype wire
