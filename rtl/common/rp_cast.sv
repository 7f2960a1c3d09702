`default_nettype none

// SC_RND and SC_SAT, as the datapath's Cast does them: SHIFT bits are dropped after half of the
// last one kept is added (ties go up), then the value is clamped to OW bits. Signed; no register.
module rp_cast #(
    parameter integer W     = 32,  // bits of x
    parameter integer SHIFT = 8,   // bits dropped; below 0: bits gained
    parameter integer OW    = 16   // bits of the result
) (
    input  wire signed [W-1:0]  x,
    output wire signed [OW-1:0] y
);
    // Room for the carry of the rounding, for the bits gained, and for the comparison below.
    localparam integer GAINED = (SHIFT < 0) ? -SHIFT : 0;
    localparam integer WIDE   = ((W + GAINED > OW) ? W + GAINED : OW) + 2;

    wire signed [WIDE-1:0] wide = WIDE'(x);
    wire signed [WIDE-1:0] rounded;

    generate
        if (SHIFT > 0) begin : g_drop
            assign rounded = (wide + (WIDE'(1) <<< (SHIFT - 1))) >>> SHIFT;
        end else begin : g_gain
            assign rounded = wide <<< GAINED;
        end
    endgenerate

    localparam signed [WIDE-1:0] HIGH = (WIDE'(1) <<< (OW - 1)) - WIDE'(1);

    assign y = (rounded > HIGH) ? {1'b0, {OW-1{1'b1}}}
             : (rounded < ~HIGH) ? {1'b1, {OW-1{1'b0}}}
             : rounded[OW-1:0];
endmodule

`default_nettype wire
