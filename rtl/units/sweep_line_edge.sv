`default_nettype none

// The points of a half's edge, one after the other, in slots. The next one is compared after the
// left side may have taken the one before it, so two are looked at: Vedge, and one step on.
module sweep_line_edge #(
    parameter integer ROW = 15                  // bits of a side coordinate
) (
    input  wire             clk,
    input  wire             step,
    input  wire             taken,              // the left side has taken Vedge
    input  wire             sent_right,         // Vedge has been sent for the right side
    input  wire             load,               // another half begins,
    input  wire             forget,             //   with a Vedge that was not sent,
    input  wire             moved,              //   one step from the edge's start
    input  wire [2*ROW+29:0] slots,             // its row and column, with remainders

    input  wire [13:0]      columns,            // of the half
    input  wire [13:0]      steps,              // of the edge, and rows a step
    input  wire [1:0]       quotient,
    input  wire [14:0]      rest,
    input  wire [13:0]      column,             // where the sides are
    input  wire [13:0]      next_column,

    output wire [ROW-1:0]   row,                // of Vedge
    output wire [ROW-1:0]   row_1,              //   and the point behind it
    output reg  [13:0]      at,                 // steps from the edge's start
    output wire [13:0]      at_1,
    output wire             in_left,            // it is in the left column
    output wire             in_right,
    output wire             in_left_1,
    output wire             in_right_1,
    output wire             moves,              // there is another point
    output reg              sent                // Vedge is in a strip register
);
    localparam integer SW = ROW + 15;           // a slot coordinate and its remainder

    reg           valid;                        // the end has not been taken
    reg  [SW-1:0] row_slot, column_slot;
    wire [SW-1:0] row_next, column_next;
    wire          whole = columns == steps;     // a column a step

    sweep_line_slot #(.ROW(ROW)) row_on (
        .slot(row_slot), .quotient(quotient), .rest(rest), .steps(steps), .moved(row_next)
    );
    sweep_line_slot #(.ROW(ROW)) column_on (
        .slot(column_slot), .quotient({1'b0, whole}), .rest(whole ? 15'd0 : {columns, 1'b0}),
        .steps(steps), .moved(column_next)
    );

    // R3: all points but the end stay out of the last column.
    wire [13:0] before_last = columns - 1'b1;
    function automatic [13:0] column_of(
        input [13:0] step_number, input [13:0] slot, input [13:0] n, input [13:0] width,
        input [13:0] most
    );
        column_of = (step_number == n) ? width : (slot >= width) ? most : slot;
    endfunction
    wire [13:0] here = column_of(at, column_slot[15 +: 14], steps, columns, before_last);
    wire [13:0] then_in = column_of(at_1, column_next[15 +: 14], steps, columns, before_last);
    wire        valid_1 = valid & at != steps;

    assign row        = row_slot[SW-1:15];
    assign row_1      = row_next[SW-1:15];
    assign at_1       = at + 1'b1;
    assign in_left    = valid & here == column;
    assign in_right   = valid & here == next_column;
    assign in_left_1  = valid_1 & then_in == column;
    assign in_right_1 = valid_1 & then_in == next_column;
    assign moves      = taken & valid_1;

    always_ff @(posedge clk) begin
        if (step & taken) begin
            valid <= valid_1;
            if (valid_1) begin
                row_slot    <= row_next;
                column_slot <= column_next;
                at          <= at_1;
            end
        end
        if (step & sent_right) sent <= 1'b1;
        else if (step & taken) sent <= 1'b0;
        if (load) begin
            valid <= 1'b1;
            {row_slot, column_slot} <= slots;
            at    <= {13'd0, moved};
            if (forget) sent <= 1'b0;
        end
    end
endmodule

`default_nettype wire
