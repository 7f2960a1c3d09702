`default_nettype none

// Get Triangle's second half (Doggett and Hirche 2000, section 3.1): the edges 12, 23, 31 of a
// triangle, one a cycle, for the tests pipeline. An edge is eligible if its new vertex stays within
// the generation cap and if no ancestor's test has found it unsplit; otherwise it is decided.
//
// Whatever else travels with a triangle stands in the user's registers, enabled by `load` and
// selected by `number`.
//
// Time: D(i,0) = max(A(i) + 1, R), D(i,j) = max(D(i,j-1) + 1, R), A(i+1) = max(V, D(i,2)).
module edge_iter (
    input  wire       clk,
    input  wire       rst_n,        // synchronous, low

    // A register, stable while triangles are in the unit.
    input  wire [3:0] cap,          // the highest generation of a new vertex

    input  wire       in_valid,
    output wire       in_ready,
    input  wire [3:0] generation1,  // of corner 1
    input  wire [3:0] generation2,
    input  wire [3:0] generation3,
    input  wire [2:0] unsplit,      // bit e: edge e is known to be unsplit

    output wire       out_valid,
    input  wire       out_ready,
    output wire [1:0] number,       // of the edge
    output wire       eligible,     // it may be split
    output wire       last,         // it is the triangle's last
    output wire       load          // a triangle is taken: enable of the user's own registers
);
    // The new vertex is one generation above the higher of the ends.
    function automatic below_cap(input [3:0] a, input [3:0] b, input [3:0] limit);
        below_cap = ((a > b) ? a : b) < limit;
    endfunction

    wire [2:0] may_split = ~unsplit & {below_cap(generation3, generation1, cap),
                                       below_cap(generation2, generation3, cap),
                                       below_cap(generation1, generation2, cap)};
    wire [2:0] edges;               // eligible or not, of the triangle inside

    rp_expand #(.W(3), .NW(2)) edges_in_turn (
        .clk      (clk),
        .rst_n    (rst_n),
        .in_valid (in_valid),
        .in_ready (in_ready),
        .in_data  (may_split),
        .in_n     (2'd3),
        .out_valid(out_valid),
        .out_ready(out_ready),
        .out_data (edges),
        .out_j    (number),
        .out_last (last),
        .load     (load)
    );

    assign eligible = (number == 2'd0) ? edges[0] : (number == 2'd1) ? edges[1] : edges[2];
endmodule

`default_nettype wire
