`default_nettype none

// The displacement in world units: D = height * mantissa * 2^-exponent + bias, SC_RND and SC_SAT
// after the product and again after the sum.
//
// Stage 1: the product. Stage 2: shift and round. Stage 3: the sum.
module displace_scale #(
    parameter integer HW   = 24,  // bits of a height, unsigned
    parameter integer FRAC = 20,  // of D, less those that a height has beyond a stored one
    parameter integer DW   = 32   // bits of D
) (
    input  wire                 clk,
    input  wire [2:0]           load,
    input  wire [HW-1:0]        height,
    input  wire [24:0]          mantissa,
    input  wire [5:0]           exponent,
    input  wire signed [DW-1:0] bias,
    output reg  signed [DW-1:0] d
);
    // The product is raised first, so that only a right shift depends on the exponent.
    localparam integer RAISED  = (FRAC > 0) ? FRAC : 0;
    localparam integer LOWERED = (FRAC < 0) ? -FRAC : 0;
    localparam integer PW      = HW + 25;
    localparam integer WIDE    = ((PW + RAISED > DW) ? PW + RAISED : DW) + 1;

    localparam [WIDE-1:0] HIGH = (WIDE'(1) << (DW - 1)) - WIDE'(1);

    wire [6:0]      shift = {1'b0, exponent} + 7'(LOWERED);
    reg  [PW-1:0]   product;
    reg  [DW-1:0]   scaled;       // not negative

    wire [WIDE-1:0] half    = (WIDE'(1) << shift) >> 1;
    wire [WIDE-1:0] rounded = ((WIDE'(product) << RAISED) + half) >> shift;
    wire signed [DW-1:0] sum;

    always_ff @(posedge clk) begin
        if (load[0]) product <= PW'(height) * PW'(mantissa);
        if (load[1]) scaled <= (rounded > HIGH) ? HIGH[DW-1:0] : rounded[DW-1:0];
        if (load[2]) d <= sum;
    end

    wire signed [DW-1:0] from_zero = $signed(scaled);

    rp_cast #(.W(DW + 1), .SHIFT(0), .OW(DW)) limit (
        .x((DW+1)'(from_zero) + (DW+1)'(bias)), .y(sum)
    );
endmodule

`default_nettype wire
