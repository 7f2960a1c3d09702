`default_nettype none

// A slot coordinate, one step on: `slot` is {position, remainder}, and advances by
// quotient + rest / (2 steps), half up, exactly. Combinational.
//
// Remainders are below 2 * 8192, so their sum fits 15 bits; a sixteenth is for the comparison.
module sweep_line_slot #(
    parameter integer ROW = 15              // bits of a position
) (
    input  wire [ROW+14:0] slot,
    input  wire [1:0]      quotient,        // -1, 0 or 1
    input  wire [14:0]     rest,
    input  wire [13:0]     steps,           // 1..8192
    output wire [ROW+14:0] moved
);
    wire [15:0] modulus = {1'b0, steps, 1'b0};
    wire [15:0] sum     = {1'b0, slot[14:0]} + {1'b0, rest};
    wire        carry   = sum >= modulus;
    wire [15:0] reduced = carry ? sum - modulus : sum;
    wire        unused_top = reduced[15];

    assign moved = {slot[ROW+14:15] + {{(ROW - 2){quotient[1]}}, quotient} + ROW'(carry),
                    reduced[14:0]};
endmodule

`default_nettype wire
