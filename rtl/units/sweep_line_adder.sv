`default_nettype none

// The one operation on vertex data: the sum, or difference, of two vectors of COMPONENTS values
// with remainders (decisions/sweep-line.md, section 3). A remainder counts units of 1/modulus and
// stays below it, so two of them, RW bits each, need one bit more; what exceeds the modulus is
// carried into the value. Values wrap. Without EXACT there are no remainders. Combinational.
module sweep_line_adder #(
    parameter integer COMPONENTS = 13,
    parameter integer VW    = 32,               // bits of a value
    parameter integer RW    = 27,               // bits of a remainder
    parameter integer EXACT = 1
) (
    input  wire                     subtract,
    input  wire [RW:0]              modulus,
    input  wire [COMPONENTS*VW-1:0] a,
    input  wire [COMPONENTS*RW-1:0] a_rest,
    input  wire [COMPONENTS*VW-1:0] b,
    input  wire [COMPONENTS*RW-1:0] b_rest,
    output wire [COMPONENTS*VW-1:0] sum,
    output wire [COMPONENTS*RW-1:0] sum_rest
);
    genvar i;
    generate
        for (i = 0; i < COMPONENTS; i = i + 1) begin : g_component
            wire carry;                         // or borrow
            if (EXACT != 0) begin : g_exact
                // Taking away b is taking away modulus and adding modulus - b.
                wire [RW+1:0] first  = {2'b0, a_rest[i*RW +: RW]};
                wire [RW+1:0] second = subtract ? -{2'b0, b_rest[i*RW +: RW]}
                                                : {2'b0, b_rest[i*RW +: RW]};
                wire [RW+1:0] rest   = first + second;
                wire [RW+1:0] other  = subtract ? rest + {1'b0, modulus} : rest - {1'b0, modulus};
                assign carry = subtract ? rest[RW+1] : ~other[RW+1];
                wire [RW+1:0] chosen = carry ? other : rest;
                assign sum_rest[i*RW +: RW] = chosen[RW-1:0];
                wire unused_top = &{1'b0, chosen[RW+1:RW]};
            end else begin : g_plain
                assign carry = 1'b0;
                assign sum_rest[i*RW +: RW] = '0;
            end
            assign sum[i*VW +: VW] = subtract
                ? a[i*VW +: VW] - b[i*VW +: VW] - VW'(carry)
                : a[i*VW +: VW] + b[i*VW +: VW] + VW'(carry);
        end
    endgenerate
    generate
        if (EXACT == 0) begin : g_unused
            wire unused_rests = &{1'b0, modulus, a_rest, b_rest};
        end
    endgenerate
endmodule

`default_nettype wire
