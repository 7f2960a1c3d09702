`default_nettype none

// The View Test (Doggett and Hirche 2000, section 2.4): vt = 1 if the edge is longer on the screen
// than the threshold, in Manhattan distance, strictly; and always if one of its ends is not in
// front of the near plane, where a screen position means nothing.
//
// Stage 1: |x1 - x2| and |y1 - y2|. Stage 2: their sum against the threshold.
//
// Time: latency 2, one item a cycle, in_ready follows out_ready.
module view_test #(
`include "rtl/units/view_test_params.svh"
) (
    input  wire                           clk,
    input  wire                           rst_n,      // synchronous, low

    // A register, stable while items are in the unit. |dx| + |dy| needs one bit more than x.
    input  wire        [SCREEN_WIDTH:0]   threshold,

    input  wire                           in_valid,
    output wire                           in_ready,
    input  wire                           skip,       // the edge is decided: pass with vt = 0
    input  wire                           near1,      // end 1 is not in front of the near plane
    input  wire signed [SCREEN_WIDTH-1:0] x1,         // end 1 in pixels, saturated
    input  wire signed [SCREEN_WIDTH-1:0] y1,
    input  wire                           near2,      // end 2 likewise
    input  wire signed [SCREEN_WIDTH-1:0] x2,
    input  wire signed [SCREEN_WIDTH-1:0] y2,

    output wire                           out_valid,
    input  wire                           out_ready,
    output wire                           vt,         // the edge is longer than the threshold
    output wire        [1:0]              load        // enables of stages 1 and 2, the user's too
);
    // |a - b| of two signed W-bit numbers lies within 0 .. 2^W - 1: W bits, unsigned. The operands
    // of the chosen subtraction are in order, so taking its low W bits loses nothing.
    function automatic [SCREEN_WIDTH-1:0] absolute_difference(
        input signed [SCREEN_WIDTH-1:0] a,
        input signed [SCREEN_WIDTH-1:0] b
    );
        absolute_difference = (a < b) ? b - a : a - b;
    endfunction

    wire skipped;                          // the item at the output was skipped

    rp_pipe #(.W(1), .L(2)) stages (
        .clk      (clk),
        .rst_n    (rst_n),
        .in_valid (in_valid),
        .in_ready (in_ready),
        .in_data  (skip),
        .out_valid(out_valid),
        .out_ready(out_ready),
        .out_data (skipped),
        .load     (load)
    );

    // Stage 1.
    reg [SCREEN_WIDTH-1:0] dx;
    reg [SCREEN_WIDTH-1:0] dy;
    reg                    near;           // some end is not in front of the near plane

    always_ff @(posedge clk) begin
        if (load[0]) begin
            dx   <= absolute_difference(x1, x2);
            dy   <= absolute_difference(y1, y2);
            near <= near1 | near2;
        end
    end

    // Stage 2.
    wire [SCREEN_WIDTH:0] distance = {1'b0, dx} + {1'b0, dy};
    reg                   long_edge;

    always_ff @(posedge clk) begin
        if (load[1]) long_edge <= near | (distance > threshold);
    end

    assign vt = long_edge & ~skipped;
endmodule

`default_nettype wire
