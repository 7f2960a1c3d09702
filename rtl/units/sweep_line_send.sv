`default_nettype none

// What the sweep line remembers about the stripping unit: which of its registers plays which part,
// and how full its FIFOs are. See sweep_line_commands for what is done with it.
//
// The state changes with `step`. `load_fresh` and `load_item` say that with this step a walk along
// the primary edge, and a base triangle, begins: the same commands for the same triangle, whatever
// went before.
module sweep_line_send #(
    parameter integer COLUMN_DEPTH = 256,
    parameter integer ROW = 15                  // bits of a side coordinate
) (
    input  wire           clk,
    input  wire           rst_n,
    input  wire           step,
    input  wire           load_fresh,
    input  wire           load_item,
    input  wire           column_end,           // the column is finished with this step

    // See sweep_line_commands.
    input  wire [2:0]     kind,
    input  wire           first,
    input  wire           right_first,
    input  wire [1:0]     left,
    input  wire [1:0]     right,
    input  wire           edge_sent,
    input  wire [ROW-1:0] left_top,
    input  wire [ROW-1:0] right_top,
    input  wire           flip,
    input  wire           last,
    input  wire           continues,
    input  wire           second,
    input  wire           another,
    output wire [23:0]    commands,
    output wire [2:0]     count,
    output wire           init,
    output wire           init_flip,
    output wire [11:0]    sources,
    output wire [2:0]     vertex_count,
    output wire           keep_right,
    output wire           from_fifo             // the left side's next inside vertex is in a FIFO
);
    localparam integer CW = (COLUMN_DEPTH > 0) ? $clog2(COLUMN_DEPTH + 1) : 1;
    localparam integer ZW = 16 + ROW + 4 * CW;

    reg  [ZW-1:0] state;
    wire [ZW-1:0] state_next;

    sweep_line_commands #(.COLUMN_DEPTH(COLUMN_DEPTH), .ROW(ROW), .CW(CW)) making (
        .state(state), .state_next(state_next), .kind(kind), .first(first),
        .right_first(right_first), .left(left), .right(right), .edge_sent(edge_sent),
        .left_top(left_top), .right_top(right_top), .flip(flip), .last(last),
        .continues(continues), .second(second), .another(another), .commands(commands),
        .count(count), .init(init), .init_flip(init_flip), .sources(sources),
        .vertex_count(vertex_count), .keep_right(keep_right)
    );

    // ---- between beats --------------------------------------------------------------------------
    wire [9:0]     places;                      // left, spare, start, edge, right
    wire           spare_is_left, spare_is_right, left_is_older, fresh, column_full, split_full;
    wire [ROW-1:0] spare_row;
    wire [CW-1:0]  column_fill, kept_left, kept_right, split_fill;
    assign {places, spare_is_left, spare_is_right, left_is_older, fresh, column_full, split_full,
            spare_row, column_fill, kept_left, kept_right, split_fill} = state_next;

    wire no_spare = load_fresh | column_end;
    wire [ZW-1:0] state_then = {
        load_item ? {2'd0, 2'd1, 2'd2, 2'd3, 2'd2} : places,
        ~load_fresh & (column_end ? spare_is_right : spare_is_left),
        ~no_spare & spare_is_right, left_is_older, load_fresh | fresh, column_full,
        ~load_item & split_full, spare_row,
        load_fresh ? {CW{1'b0}} : column_fill,
        load_fresh ? {CW{1'b0}} : column_end ? kept_right : kept_left,
        kept_right, load_item ? {CW{1'b0}} : split_fill};

    assign from_fifo = state[3*CW-1 -: CW] != '0;

    always_ff @(posedge clk) begin
        if (!rst_n) state <= '0;
        else if (step) state <= state_then;
    end
endmodule

`default_nettype wire
