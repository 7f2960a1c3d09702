`default_nettype none

// One component of the Normal Test: does it differ between the midpoint and an end by more than the
// threshold, strictly?
//
// Stage 1: |a - b|. Stage 2 belongs to the caller: `beyond` is the comparison, not registered.
module normal_test_difference #(
    parameter integer W  = 13,  // bits of a component
    parameter integer TW = 13   // bits of the threshold, >= W
) (
    input  wire                clk,
    input  wire                load,       // enable of stage 1
    input  wire signed [W-1:0] a,
    input  wire signed [W-1:0] b,
    input  wire       [TW-1:0] threshold,
    output wire                beyond
);
    // |a - b| of two signed W-bit numbers: W bits, unsigned. The operands of the chosen
    // subtraction are in order, so its low W bits lose nothing.
    reg [W-1:0] d;

    always_ff @(posedge clk) begin
        if (load) d <= (a < b) ? b - a : a - b;
    end

    assign beyond = TW'(d) > threshold;
endmodule

`default_nettype wire
