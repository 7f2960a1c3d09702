`default_nettype none

// One step of the side walk: which side of the strip moves up, onto what, and whether the column is
// finished (decisions/sweep-line.md, section 1.5). Rows are compared, nothing is added. The edge's
// next point is looked at twice: before the left side moves, and after it may have taken one.
// Combinational.
//
// A fan of ears (repair R8) takes a beat an ear: the first one has two edge points, so the edge
// then moves on for another cycle.
module sweep_line_step #(
    parameter integer ROW = 15                  // bits of a side coordinate
) (
    input  wire           abort_all,
    input  wire           single,               // a base triangle on one grid point
    input  wire           over_limit,           // one step more than the column may take
    input  wire [1:0]     ear,                  // state of the fan
    output reg  [1:0]     ear_next,

    input  wire           first,                // of the column
    input  wire           closes,               // the last column before a tip
    input  wire           other_left,           // this column is the other half's edge
    input  wire           other_right,
    input  wire           edged,                // the left side is on the edge
    input  wire           done,                 // the right side has nowhere to go
    input  wire [ROW-1:0] left_up,              // the next rows of both sides
    input  wire [ROW-1:0] right_up,
    input  wire [ROW-1:0] other_up,             // of the other half's edge
    input  wire           other_ends,           //   which ends there
    input  wire [ROW-1:0] edge_row,             // Vedge,
    input  wire           edge_in_left,         //   is in this column,
    input  wire           edge_in_right,        //   in the next one
    input  wire [ROW-1:0] edge1_row,            // the point behind it
    input  wire           edge1_in_left,
    input  wire           edge1_in_right,

    output reg  [2:0]     kind,                 // see sweep_line_commands
    output reg            right_first,
    output reg  [1:0]     left,                 // onto what a side steps: 0 it stays, 1 inside,
    output reg  [1:0]     right,                //   2 the edge, 3 the other half's edge
    output reg  [ROW-1:0] left_top,             // and the row there
    output reg  [ROW-1:0] right_top,
    output reg            edged_next,
    output reg            done_next,
    output reg            edge_step,            // an edge point has been taken
    output reg            column_end,
    output reg            give_up,              // end the base triangle with an empty beat,
    output reg            runaway               //   because a column took too many steps
);
    localparam [1:0] STAY = 2'd0, INSIDE = 2'd1, ON_EDGE = 2'd2, ON_OTHER = 2'd3;
    localparam [1:0] NO_EAR = 2'd0, FIRST_EAR = 2'd1, SKIP = 2'd2, FAN = 2'd3;

    reg           can_left, can_right, go_left, go_right, in_left, in_right;
    reg [ROW-1:0] row_e;

    always_comb begin
        kind        = 3'd0;
        left        = STAY;
        right       = STAY;
        edge_step   = 1'b0;
        column_end  = 1'b0;
        give_up     = 1'b0;
        runaway     = 1'b0;
        right_first = 1'b0;
        ear_next       = ear;
        edged_next     = edged;
        done_next      = done;
        left_top    = left_up;
        right_top   = right_up;
        row_e       = edge_row;
        in_left     = edge_in_left;
        in_right    = edge_in_right;

        can_left  = ~edged | edge_in_left;
        can_right = ~done;
        go_left   = can_left & ~(can_right & $signed(left_up) > $signed(right_up));
        go_right  = can_right & ~(can_left & $signed(right_up) > $signed(left_up));
        // R7: the next edge point is the left side's, which goes first.
        if (go_right & ~go_left & can_left & edge_in_left
            & $signed(row_e) <= $signed(right_up)) begin
            go_right = 1'b0;
            go_left  = 1'b1;
        end

        if (abort_all) begin
            give_up = 1'b1;
            kind    = 3'd5;
        end else if (single) begin
            kind = 3'd4;
        end else if (ear == SKIP) begin
            kind      = 3'd5;
            edge_step = 1'b1;
            ear_next     = FAN;
        end else if (ear == FIRST_EAR) begin
            kind      = 3'd1;
            edge_step = 1'b1;
            ear_next     = SKIP;
        end else if (ear == FAN) begin
            kind       = edge_in_left ? 3'd2 : 3'd3;
            edge_step  = edge_in_left;
            column_end = ~edge_in_left;
            ear_next      = edge_in_left ? FAN : NO_EAR;
        end else if (over_limit) begin
            give_up = 1'b1;
            runaway = 1'b1;
            kind    = 3'd5;
        end else begin
            right_first = ~go_left;
            if (go_left) begin
                if (other_left & ~edged) begin
                    left     = ON_OTHER;
                    left_top = other_up;
                    edged_next  = other_ends;
                end else if (edged | (edge_in_left & $signed(row_e) <= $signed(left_up))) begin
                    left      = ON_EDGE;                                   // R1, R2
                    left_top  = row_e;
                    edged_next   = 1'b1;
                    edge_step = 1'b1;
                    row_e     = edge1_row;
                    in_left   = edge1_in_left;
                    in_right  = edge1_in_right;
                end else left = INSIDE;
            end
            if (left == ON_EDGE & closes & in_left) begin
                // R8: more points of the edge before the tip. The strip's two lower vertices go
                // out first if they have not yet.
                edge_step = ~first;
                kind      = first ? 3'd0 : 3'd1;
                ear_next     = first ? FIRST_EAR : SKIP;
                left      = STAY;
            end else begin
                // R7 again, for the point that is next now.
                if (go_left & in_left & $signed(row_e) <= $signed(right_up)) go_right = 1'b0;
                if (go_right) begin
                    if (other_right) begin
                        right     = ON_OTHER;
                        right_top = other_up;
                        done_next    = other_ends;
                    end else if (in_right & $signed(row_e) <= $signed(right_up)) begin
                        right     = ON_EDGE;
                        right_top = row_e;
                        done_next    = 1'b1;
                    end else right = INSIDE;
                end
                column_end = (edged_next & ~in_left) & done_next;
            end
        end
    end
endmodule

`default_nettype wire
