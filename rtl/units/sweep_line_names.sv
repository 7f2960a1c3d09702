`default_nettype none

// Names of the vertices that a beat may send: what each is in its base triangle, independent of
// its data. 32 bits each: kind (0 corner, 1 edge, 2 interior), corner or edge, step of the edge or
// sweep coordinate, side coordinate. Combinational.
module sweep_line_names (
    input  wire         single,                 // the three corners instead
    input  wire         mirrored,               // the side axis is negated in the local frame
    // Walks: edge, from, to, backward, steps; and the steps in question.
    input  wire [20:0]  walk,
    input  wire [20:0]  edge_walk,
    input  wire [20:0]  other,
    input  wire [13:0]  walk_at,
    input  wire [13:0]  edge_at,
    input  wire [13:0]  edge1_at,
    input  wire [13:0]  other_at,
    input  wire         left_on_other,          // a side is on the other half's edge
    input  wire         right_on_other,
    input  wire [13:0]  left_sweep,
    input  wire [13:0]  right_sweep,
    input  wire [13:0]  left_row,
    input  wire [13:0]  right_row,
    output wire [191:0] names                   // right, left, edge one step on, edge, start, bl
);
    function automatic [31:0] corner(input [1:0] part);
        corner = {2'd0, part, 28'd0};
    endfunction

    // The vertex at a step of an edge. Its ends are corners, so that the last accumulated value,
    // which the rounding kinds of adder miss, is never sent.
    function automatic [31:0] point(input [20:0] along, input [13:0] at);
        point = (at == '0) ? {2'd0, along[18:17], 28'd0}
              : (at == along[13:0]) ? {2'd0, along[16:15], 28'd0}
              : {2'd1, along[20:19], along[14] ? along[13:0] - at : at, 14'd0};
    endfunction

    function automatic [31:0] interior(input [13:0] s, input [13:0] row, input negated);
        interior = {2'd2, 2'd0, s, negated ? -row : row};
    endfunction

    wire [31:0] name_other = point(other, other_at);
    wire [31:0] name_left  = single ? corner(2'd0) : corner(walk[18:17]);
    wire [31:0] name_start = single ? corner(2'd1) : point(walk, walk_at);
    wire [31:0] name_edge  = single ? corner(2'd2) : point(edge_walk, edge_at);
    wire [31:0] name_edge1 = point(edge_walk, edge1_at);
    wire [31:0] name_tl = left_on_other ? name_other : interior(left_sweep, left_row, mirrored);
    wire [31:0] name_tr = right_on_other ? name_other
                                         : interior(right_sweep, right_row, mirrored);
    assign names = {name_tr, name_tl, name_edge1, name_edge, name_start, name_left};
endmodule

`default_nettype wire
