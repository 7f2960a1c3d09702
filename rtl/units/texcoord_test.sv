`default_nettype none

// The Tex Coord Test (Doggett and Hirche 2000, section 2.5): ct = 0 if the new vertex U12 lies in
// the same texel of the map as one of the two ends, for then the map has no more detail to show.
//
// Six comparators and one register. The coordinates are signed, so dropping the fraction bits is
// a floor; they are neither clamped nor wrapped before.
//
// Time: latency 1, one item a cycle, in_ready follows out_ready.
module texcoord_test #(
`include "rtl/units/texcoord_test_params.svh"
) (
    input  wire                       clk,
    input  wire                       rst_n,      // synchronous, low

    input  wire                       in_valid,
    output wire                       in_ready,
    input  wire                       skip,       // the edge is decided: pass it on with ct = 0
    input  wire signed [UV_WIDTH-1:0] u1_x,       // end 1, in texels
    input  wire signed [UV_WIDTH-1:0] u1_y,
    input  wire signed [UV_WIDTH-1:0] u2_x,       // end 2
    input  wire signed [UV_WIDTH-1:0] u2_y,
    input  wire signed [UV_WIDTH-1:0] u12_x,      // the vertex that would split the edge
    input  wire signed [UV_WIDTH-1:0] u12_y,

    output wire                       out_valid,
    input  wire                       out_ready,
    output wire                       ct,         // U12 lies in a texel of its own
    output wire                       load        // enable of the user's own register
);

    // Equal texels: everything above the fraction agrees, in both components.
    wire same_as_1 = (u12_x >>> UV_FRAC) == (u1_x >>> UV_FRAC)
                   & (u12_y >>> UV_FRAC) == (u1_y >>> UV_FRAC);
    wire same_as_2 = (u12_x >>> UV_FRAC) == (u2_x >>> UV_FRAC)
                   & (u12_y >>> UV_FRAC) == (u2_y >>> UV_FRAC);

    rp_pipe #(.W(1), .L(1)) stages (
        .clk      (clk),
        .rst_n    (rst_n),
        .in_valid (in_valid),
        .in_ready (in_ready),
        .in_data  (~skip & ~same_as_1 & ~same_as_2),
        .out_valid(out_valid),
        .out_ready(out_ready),
        .out_data (ct),
        .load     (load)
    );

endmodule

`default_nettype wire
