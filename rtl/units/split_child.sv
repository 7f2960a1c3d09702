`default_nettype none

// The corners of a child (Doggett and Hirche 2000, figure 6): 0 to 2 are its parent's, 3 to 5 the
// new vertices of the edges 12, 23, 31. Combinational.
module split_child (
    input  wire [1:0] count,    // split edges
    input  wire [1:0] first,    // one: the edge that is split; two: the one that is not
    input  wire       shorter,  // two: the quad is cut along A-M1
    input  wire [1:0] digit,    // number of the child, in push order
    output reg  [2:0] vertex1,
    output reg  [2:0] vertex2,
    output reg  [2:0] vertex3,
    output reg  [2:0] unsplit   // bit e: edge e of the child is an edge of the parent, unsplit
);
    function automatic [1:0] next(input [1:0] i);
        next = (i == 2'd2) ? 2'd0 : i + 2'd1;
    endfunction

    // Edge `first` runs from A to B; the third corner is C.
    wire [2:0] a = {1'b0, first};
    wire [2:0] b = {1'b0, next(first)};
    wire [2:0] c = {1'b0, next(next(first))};

    // The new vertices on AB, BC and CA.
    wire [2:0] m  = 3'd3 + a;
    wire [2:0] m1 = 3'd3 + b;
    wire [2:0] m2 = 3'd3 + c;

    always_comb begin
        unsplit = 3'b000;
        case ({count, digit})
            {2'd1, 2'd0}: begin
                {vertex1, vertex2, vertex3} = {a, m, c};
                unsplit = 3'b100;
            end
            {2'd1, 2'd1}: begin
                {vertex1, vertex2, vertex3} = {m, b, c};
                unsplit = 3'b010;
            end
            {2'd2, 2'd0}: {vertex1, vertex2, vertex3} = {m2, m1, c};
            {2'd2, 2'd1}: begin
                {vertex1, vertex2, vertex3} = {a, b, shorter ? m1 : m2};
                unsplit = 3'b001;
            end
            {2'd2, 2'd2}: {vertex1, vertex2, vertex3} = {shorter ? a : b, m1, m2};
            {2'd3, 2'd0}: {vertex1, vertex2, vertex3} = {3'd0, 3'd3, 3'd5};
            {2'd3, 2'd1}: {vertex1, vertex2, vertex3} = {3'd3, 3'd1, 3'd4};
            {2'd3, 2'd2}: {vertex1, vertex2, vertex3} = {3'd5, 3'd4, 3'd2};
            {2'd3, 2'd3}: {vertex1, vertex2, vertex3} = {3'd3, 3'd4, 3'd5};
            default:      {vertex1, vertex2, vertex3} = {3'd0, 3'd1, 3'd2};
        endcase
    end
endmodule

`default_nettype wire
