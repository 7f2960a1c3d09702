`default_nettype none

// One component of perspective: the product with the reciprocal's mantissa in one stage, its cast
// (round half up, saturate) in the next.
module perspective_component #(
    parameter integer DW     = 32,   // bits of the value
    parameter integer BITS   = 24,   // of the mantissa
    parameter integer OFFSET = -30,  // fraction bits of the quotient, less those of the result
    parameter integer OW     = 32    // bits of the result
) (
    input  wire                 clk,
    input  wire [1:0]           load,      // stage enables
    input  wire signed [DW-1:0] value,     // with load[0]
    input  wire [BITS-1:0]      mantissa,
    input  wire [5:0]           exponent,
    output wire signed [OW-1:0] result     // behind load[1]
);
    localparam integer PW = DW + BITS + 1; // the mantissa becomes signed

    reg signed [PW-1:0]  product;
    reg        [5:0]     shift;
    reg signed [OW-1:0]  rounded;
    wire signed [OW-1:0] fitted;

    rp_scaled_cast #(
        .W(PW), .LEAST(BITS - 1), .MOST(BITS + 30), .OFFSET(OFFSET), .OW(OW)
    ) fit (.x(product), .exponent(shift), .y(fitted));

    always_ff @(posedge clk) begin
        if (load[0]) begin
            product <= PW'(value) * $signed(PW'(mantissa));
            shift   <= exponent;
        end
        if (load[1]) rounded <= fitted;
    end

    assign result = rounded;
endmodule

`default_nettype wire
