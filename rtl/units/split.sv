`default_nettype none

// Pass or Tessellate, and Tessellation (Doggett and Hirche 2000, sections 2.6 and 3.1.5, figure 6):
// an edge is split if it is eligible, ct, vt, and nt or sht. A triangle without a split edge
// passes; otherwise its children leave one a cycle. With two split edges a quad is left over, cut
// along the diagonal that is shorter after displacement.
//
// Stage 1: decisions, and the ends of both diagonals. Stages 2 and 3: cast differences, squares.
// Stage 4: the comparison. Stage 5: a child a cycle. Corners are named by number; the vertices
// themselves stand in the user's registers, enabled by `load`.
//
// Time: latency 5, capacity 5, as many cycles an item as it has children, in_ready follows
// out_ready.
module split #(
`include "rtl/units/split_params.svh"
) (
    input  wire                             clk,
    input  wire                             rst_n,             // synchronous, low

    // A register, stable while triangles are in the unit. Without a surface test (nt or sht) every
    // edge counts as detailed.
    input  wire                             has_surface_test,

    input  wire                             in_valid,
    output wire                             in_ready,
    input  wire        [2:0]                eligible,   // bit e: of edge e
    input  wire        [2:0]                ct,
    input  wire        [2:0]                vt,
    input  wire        [2:0]                nt,
    input  wire        [2:0]                sht,
    input  wire signed [POSITION_WIDTH-1:0] corner1_x,  // P' of the corners
    input  wire signed [POSITION_WIDTH-1:0] corner1_y,
    input  wire signed [POSITION_WIDTH-1:0] corner1_z,
    input  wire signed [POSITION_WIDTH-1:0] corner2_x,
    input  wire signed [POSITION_WIDTH-1:0] corner2_y,
    input  wire signed [POSITION_WIDTH-1:0] corner2_z,
    input  wire signed [POSITION_WIDTH-1:0] corner3_x,
    input  wire signed [POSITION_WIDTH-1:0] corner3_y,
    input  wire signed [POSITION_WIDTH-1:0] corner3_z,
    input  wire signed [POSITION_WIDTH-1:0] mid12_x,    // P' of the new vertices
    input  wire signed [POSITION_WIDTH-1:0] mid12_y,
    input  wire signed [POSITION_WIDTH-1:0] mid12_z,
    input  wire signed [POSITION_WIDTH-1:0] mid23_x,
    input  wire signed [POSITION_WIDTH-1:0] mid23_y,
    input  wire signed [POSITION_WIDTH-1:0] mid23_z,
    input  wire signed [POSITION_WIDTH-1:0] mid31_x,
    input  wire signed [POSITION_WIDTH-1:0] mid31_y,
    input  wire signed [POSITION_WIDTH-1:0] mid31_z,

    output wire                             out_valid,
    input  wire                             out_ready,
    output wire        [1:0]                digit,      // number of the child
    output wire        [2:0]                vertex1,    // its corners: 0 to 2 the parent's,
    output wire        [2:0]                vertex2,    // 3 to 5 the new vertices
    output wire        [2:0]                vertex3,
    output wire        [2:0]                unsplit,    // bit e: known to be unsplit
    output wire                             pass,       // no edge is split
    output wire                             last,       // the triangle's last child
    output wire        [4:0]                load        // enables of the user's own registers
);
    localparam integer PW = POSITION_WIDTH;
    localparam integer DW = DIAGONAL_WIDTH;

    // Decisions.
    wire [2:0] detailed = nt | sht | {3{~has_surface_test}};
    wire [2:0] divide   = eligible & ct & vt & detailed;
    wire [1:0] count    = {1'b0, divide[0]} + {1'b0, divide[1]} + {1'b0, divide[2]};

    // The edge that decides the rotation: the first that is split, or with two split edges the one
    // that is not.
    wire [1:0] marked = divide[1:0] ^ {2{count == 2'd2}};
    wire [1:0] first  = marked[0] ? 2'd0 : marked[1] ? 2'd1 : 2'd2;

    wire       divided_valid, divided_ready;
    wire [1:0] divided_count, divided_first;

    rp_pipe #(.W(4), .L(4)) stages (
        .clk      (clk),
        .rst_n    (rst_n),
        .in_valid (in_valid),
        .in_ready (in_ready),
        .in_data  ({count, first}),
        .out_valid(divided_valid),
        .out_ready(divided_ready),
        .out_data ({divided_count, divided_first}),
        .load     (load[3:0])
    );

    // Stage 1: A-M1 and B-M2, where A-B is the edge `first`, M1 lies on the next edge and M2 on the
    // one before.
    wire [3*PW-1:0] corner1 = {corner1_z, corner1_y, corner1_x};
    wire [3*PW-1:0] corner2 = {corner2_z, corner2_y, corner2_x};
    wire [3*PW-1:0] corner3 = {corner3_z, corner3_y, corner3_x};
    wire [3*PW-1:0] mid12   = {mid12_z, mid12_y, mid12_x};
    wire [3*PW-1:0] mid23   = {mid23_z, mid23_y, mid23_x};
    wire [3*PW-1:0] mid31   = {mid31_z, mid31_y, mid31_x};
    reg  [3*PW-1:0] a, b, m1, m2;

    always_ff @(posedge clk) begin
        if (load[0]) begin
            a  <= (first == 2'd0) ? corner1 : (first == 2'd1) ? corner2 : corner3;
            b  <= (first == 2'd0) ? corner2 : (first == 2'd1) ? corner3 : corner1;
            m1 <= (first == 2'd0) ? mid23 : (first == 2'd1) ? mid31 : mid12;
            m2 <= (first == 2'd0) ? mid31 : (first == 2'd1) ? mid12 : mid23;
        end
    end

    // Stages 2 and 3.
    wire [2*DW-1:0] length1, length2;

    split_length #(.PW(PW), .SHIFT(POSITION_FRAC - DIAGONAL_FRAC), .DW(DW)) diagonal1 (
        .clk(clk), .load(load[2:1]), .p(a), .q(m1), .length(length1)
    );
    split_length #(.PW(PW), .SHIFT(POSITION_FRAC - DIAGONAL_FRAC), .DW(DW)) diagonal2 (
        .clk(clk), .load(load[2:1]), .p(b), .q(m2), .length(length2)
    );

    // Stage 4.
    reg shorter;  // the first diagonal, or as long

    always_ff @(posedge clk) begin
        if (load[3]) shorter <= length1 <= length2;
    end

    // Stage 5.
    wire [1:0] child_count, child_first;
    wire       child_shorter;
    wire [2:0] j;

    rp_expand #(.W(5), .NW(3)) children (
        .clk      (clk),
        .rst_n    (rst_n),
        .in_valid (divided_valid),
        .in_ready (divided_ready),
        .in_data  ({divided_count, divided_first, shorter}),
        .in_n     ({1'b0, divided_count} + 3'd1),
        .out_valid(out_valid),
        .out_ready(out_ready),
        .out_data ({child_count, child_first, child_shorter}),
        .out_j    (j),
        .out_last (last),
        .load     (load[4])
    );

    split_child child (
        .count  (child_count),
        .first  (child_first),
        .shorter(child_shorter),
        .digit  (digit),
        .vertex1(vertex1),
        .vertex2(vertex2),
        .vertex3(vertex3),
        .unsplit(unsplit)
    );

    wire unused_j = &{1'b0, j[2]};  // a fourth child is the last

    assign digit = j[1:0];
    assign pass  = child_count == 2'd0;
endmodule

`default_nettype wire
