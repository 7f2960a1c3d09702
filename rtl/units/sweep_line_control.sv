`default_nettype none

// The sweep line's control: base triangles in, beats out, on slots alone. What a beat tells the
// data stage and carries past it is one vector, taken apart in sweep_line.
module sweep_line_control #(
    parameter integer SW  = 309,                // scalars of an item
    parameter integer UW  = 199,                // bits of a beat
    parameter integer COLUMN_DEPTH = 256
) (
    input  wire            clk,
    input  wire            rst_n,
    input  wire            abort_all,
    input  wire [1:0]      waiting,             // see sweep_line_halves
    output wire [1:0]      halves_done,
    input  wire [2*SW-1:0] items,
    output wire            walk_valid,
    input  wire            walk_ready,
    output wire [UW-1:0]   beat
);
    localparam integer HW  = 217;               // description of a half
    localparam integer ROW = 15;                // a side coordinate, and a row beyond +-4096

    wire            half_valid, half_ready;
    wire [HW-1:0]   half, current;
    wire [4*ROW+45:0] initial_slots;

    sweep_line_halves #(.SW(SW), .HW(HW), .ROW(ROW)) halves (
        .clk(clk), .rst_n(rst_n), .waiting(waiting), .done(halves_done), .items(items),
        .out_valid(half_valid), .out_ready(half_ready), .half(half),
        .initial_slots(initial_slots)
    );

    wire            first, right_first, edge_sent, column_end, edge_moves;
    wire            edge_moved, crosses, falls, column_ahead;
    wire            give_up, gave_up, item_end, load_fresh, load_item, half_start, walk_start;
    wire            next_crosses, last_column, other_left, other_right, keep_right, from_fifo;
    wire [2:0]      beat_kind;
    wire [1:0]      left, right;
    wire [ROW-1:0]  left_top, right_top;
    wire [191:0]    names;

    sweep_line_walk #(.HW(HW), .ROW(ROW)) walk (
        .clk(clk), .rst_n(rst_n), .abort_all(abort_all),
        .half_valid(half_valid), .half_ready(half_ready), .half(half),
        .initial_slots(initial_slots),
        .out_valid(walk_valid), .out_ready(walk_ready), .kind(beat_kind), .first(first),
        .right_first(right_first), .left(left), .right(right), .left_top(left_top),
        .right_top(right_top), .edge_sent(edge_sent), .column_end(column_end),
        .edge_moves(edge_moves), .edge_moved(edge_moved), .crosses(crosses), .falls(falls),
        .column_ahead(column_ahead), .give_up(give_up), .runaway(gave_up), .item_end(item_end),
        .load_fresh(load_fresh), .load_item(load_item), .half_start(half_start),
        .walk_start(walk_start), .next_crosses(next_crosses), .current(current),
        .last_column(last_column), .other_left(other_left), .other_right(other_right),
        .names(names)
    );

    wire [23:0]     commands;
    wire [2:0]      command_count, new_vertices;
    wire            begin_strip, strip_flip;
    wire [11:0]     sources;

    sweep_line_send #(.COLUMN_DEPTH(COLUMN_DEPTH), .ROW(ROW)) send (
        .clk(clk), .rst_n(rst_n), .step((walk_valid & walk_ready) | load_fresh),
        .load_fresh(load_fresh), .load_item(load_item),
        .kind(walk_valid ? beat_kind : 3'd5), .first(first & walk_valid), .right_first(right_first),
        .left(left), .right(right), .edge_sent(edge_sent), .left_top(left_top),
        .right_top(right_top), .column_end(column_end & walk_valid), .flip(current[HW-57]),
        .last(last_column), .continues(current[HW-9]), .second(current[HW-2]),
        .another(current[HW-8]),
        .commands(commands), .count(command_count), .init(begin_strip), .init_flip(strip_flip),
        .sources(sources), .vertex_count(new_vertices), .keep_right(keep_right),
        .from_fifo(from_fifo)
    );

    function automatic [31:0] name_of(input [2:0] source, input [191:0] all);
        name_of = all[32 * source +: 32];
    endfunction
    wire [127:0] sent_names = {name_of(sources[11:9], names), name_of(sources[8:6], names),
                               name_of(sources[5:3], names), name_of(sources[2:0], names)};
    // Only what takes the left side up by Dside, or by another half's edge, is added here.
    wire left_add  = (left == 2'd1 & ~from_fifo) | left == 2'd3;
    wire right_add = right == 2'd1 | right == 2'd3;
    wire walks     = beat_kind == 3'd0;          // only a step starts anything
    wire emit      = beat_kind != 3'd5 | give_up;

    assign beat = {
        emit, item_end, current[HW-1], current[HW-2], current[HW-3], first & walks,
        half_start & walks, walk_start & walks, current[HW-56], crosses, falls, next_crosses,
        column_end, column_ahead, edge_moved, edge_moves, left, right, left_add, right_add,
        other_left, other_right, from_fifo, keep_right,
        sources, commands, command_count, new_vertices, begin_strip, strip_flip, gave_up,
        sent_names};
endmodule

`default_nettype wire
