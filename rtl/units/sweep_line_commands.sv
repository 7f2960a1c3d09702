`default_nettype none

// The commands of a beat for the stripping unit, which strip register each names, and where the
// vertices that go with them come from. It knows moves and counts, no vertices. Combinational.
//
// What a beat is (`kind`): 0 a step of the side walk, 1 the first ear (repair R8), 2 a further one,
// 3 the triangle behind the last, 4 a base triangle on one grid point, 5 nothing.
//
// Where a vertex comes from (`sources`): 0 the lowest of the left column, a corner, 1 Vstart,
// 2 Vedge as the beat finds it, 3 Vedge one step on, 4 the left side's sum, 5 the right side's.
//
// Strip registers go by part. The spare one holds the highest inside vertex of the left column, or
// of the right one: where a column has no other, the left side finds it there. Of a right column,
// inside vertices are kept from the lowest on without a gap, since a FIFO returns them in order.
module sweep_line_commands #(
    parameter integer COLUMN_DEPTH = 256,
    parameter integer ROW = 15,                 // bits of a side coordinate
    parameter integer CW  = 9,                  // bits of a number of vertices in a FIFO
    parameter integer ZW  = 16 + ROW + 4 * CW   // bits of the state
) (
    input  wire [ZW-1:0]  state,
    output wire [ZW-1:0]  state_next,
    input  wire [2:0]     kind,
    input  wire           first,        // the step starts a strip
    input  wire           right_first,  // with its right vertex
    input  wire [1:0]     left,         // onto what the left side steps: 0 it stays, 1 inside,
    input  wire [1:0]     right,        //   2 the edge, 3 the other half's edge
    input  wire           edge_sent,    // the edge's vertex is in a strip register
    input  wire [ROW-1:0] left_top,     // rows that the sides step to
    input  wire [ROW-1:0] right_top,
    input  wire           flip,         // winding of the half
    input  wire           last,         // its last column
    input  wire           continues,
    input  wire           second,       // the second half
    input  wire           another,      // the first half, and there is a second one
    output reg  [23:0]    commands,     // operation, register, where it is kept: 6 bits each
    output reg  [2:0]     count,
    output reg            init,
    output reg            init_flip,
    output reg  [11:0]    sources,      // of each new vertex
    output reg  [2:0]     vertex_count,
    output reg            keep_right    // the right side's vertex goes to the column FIFO
);
    localparam [CW-1:0] FULL = CW'(COLUMN_DEPTH);

    localparam [1:0] STAY = 2'd0, INSIDE = 2'd1, ON_EDGE = 2'd2, ON_OTHER = 2'd3;
    localparam [1:0] REF = 2'd0, NEW = 2'd1, COLUMN = 2'd2, SPLIT = 2'd3;
    localparam [1:0] NOWHERE = 2'd0, TO_COLUMN = 2'd1, TO_SPLIT = 2'd2;
    localparam [2:0] S_LEFT = 3'd0, S_START = 3'd1, S_EDGE = 3'd2, S_EDGE1 = 3'd3, S_TL = 3'd4,
                     S_TR = 3'd5;

    wire [1:0]     left_place, spare_place, start_place, edge_place, right_place;
    wire           spare_is_left, spare_is_right, left_is_older, fresh;
    wire [ROW-1:0] spare_row;
    wire [CW-1:0]  column_fill, kept_left, kept_right, split_fill;
    wire           column_full, split_full;

    assign {left_place, spare_place, start_place, edge_place, right_place, spare_is_left,
            spare_is_right, left_is_older, fresh, column_full, split_full, spare_row, column_fill,
            kept_left, kept_right, split_fill} = state;

    // Their next values.
    reg [1:0]     left_place_n, spare_place_n, start_place_n, edge_place_n, right_place_n;
    reg           spare_is_left_n, spare_is_right_n, left_is_older_n, fresh_n;
    reg [ROW-1:0] spare_row_n;
    reg [CW-1:0]  column_fill_n, kept_left_n, kept_right_n, split_fill_n;
    reg           column_full_n, split_full_n;

    assign state_next = {left_place_n, spare_place_n, start_place_n, edge_place_n, right_place_n,
            spare_is_left_n, spare_is_right_n, left_is_older_n, fresh_n, column_full_n,
            split_full_n, spare_row_n, column_fill_n, kept_left_n, kept_right_n, split_fill_n};

    reg [1:0] kept, freed;
    reg       in_spare;
    wire      from_fifo = kept_left != '0;

    function automatic [5:0] entry(input [1:0] op, input [1:0] place, input [1:0] keep);
        entry = {op, place, keep};
    endfunction

    // A roof's split column is kept whole by the first half; the second one has it sent from there.
    wire split_column = last & ~continues;
    wire keeps_column = (COLUMN_DEPTH > 0) & ~split_column & ~(last & ~another);

    always_comb begin
        commands        = '0;
        count           = '0;
        sources         = '0;
        vertex_count    = '0;
        init            = 1'b0;
        init_flip       = 1'b0;
        keep_right      = 1'b0;
        kept            = NOWHERE;
        freed           = 2'd0;
        in_spare        = 1'b0;
        left_place_n    = left_place;
        spare_place_n   = spare_place;
        start_place_n   = start_place;
        edge_place_n    = edge_place;
        right_place_n   = right_place;
        spare_is_left_n = spare_is_left;
        spare_is_right_n = spare_is_right;
        spare_row_n     = spare_row;
        left_is_older_n = left_is_older;
        fresh_n         = fresh;
        column_fill_n   = column_fill;
        kept_left_n     = kept_left;
        kept_right_n    = first ? '0 : kept_right;
        column_full_n   = column_full & ~first;
        split_fill_n    = split_fill;
        split_full_n    = split_full;

        if (kind == 3'd4) begin
            init         = 1'b1;
            count        = 3'd3;
            vertex_count = 3'd3;
            commands     = {6'd0, entry(NEW, 2'd2, NOWHERE), entry(NEW, 2'd1, NOWHERE),
                            entry(NEW, 2'd0, NOWHERE)};
            sources      = {3'd0, 3'd2, 3'd1, 3'd0};
        end

        // A new strip: bl, then br; the other way round if the right side moves first.
        if (kind == 3'd0 && first) begin
            left_place_n    = start_place;
            start_place_n   = left_place;
            right_place_n   = left_place;
            init            = 1'b1;
            init_flip       = flip ^ right_first;
            left_is_older_n = ~right_first;
            fresh_n         = 1'b0;
            count           = 3'd2;
            kept            = (COLUMN_DEPTH > 0 && split_column && another && !split_full)
                            ? TO_SPLIT : NOWHERE;
            if (split_column && second && split_fill != '0) begin
                split_fill_n = split_fill - 1'b1;
                commands[right_first ? 0 : 6 +: 6] = entry(SPLIT, right_place_n, NOWHERE);
            end else begin
                commands[right_first ? 0 : 6 +: 6] = entry(NEW, right_place_n, kept);
                sources[fresh & ~right_first ? 3 : 0 +: 3] = S_START;
                vertex_count = 3'd1;
                if (kept == TO_SPLIT) begin
                    split_fill_n = split_fill + 1'b1;
                    split_full_n = split_fill_n == FULL;
                end
            end
            commands[right_first ? 6 : 0 +: 6] = entry(fresh ? NEW : REF, left_place_n, NOWHERE);
            if (fresh) begin
                sources[right_first ? 3 * vertex_count : 0 +: 3] = S_LEFT;
                vertex_count = vertex_count + 1'b1;
            end
        end

        if (kind == 3'd0 && left != STAY) begin
            if (!left_is_older_n) begin  // only turns the strip
                commands[6 * count +: 6] = entry(REF, right_place_n, NOWHERE);
                count = count + 1'b1;
            end
            left_is_older_n = 1'b0;
            in_spare = left == INSIDE && spare_is_left_n && spare_row == left_top && !from_fifo;
            freed = left_place_n;
            if (in_spare) begin
                left_place_n    = spare_place;
                spare_place_n   = freed;
                spare_is_left_n = 1'b0;
                commands[6 * count +: 6] = entry(REF, left_place_n, NOWHERE);
            end else if (left == ON_EDGE && edge_sent) begin
                left_place_n    = edge_place;
                edge_place_n    = freed;
                spare_is_left_n = 1'b0;
                commands[6 * count +: 6] = entry(REF, left_place_n, NOWHERE);
            end else if (left == INSIDE && from_fifo) begin
                kept_left_n   = kept_left - 1'b1;
                column_fill_n = column_fill - 1'b1;
                commands[6 * count +: 6] = entry(COLUMN, left_place_n, NOWHERE);
            end else begin
                commands[6 * count +: 6] = entry(NEW, left_place_n, NOWHERE);
                sources[3 * vertex_count +: 3] = left == ON_EDGE ? S_EDGE : S_TL;
                vertex_count = vertex_count + 1'b1;
            end
            count = count + 1'b1;
        end

        if (kind == 3'd0 && right != STAY) begin
            if (left_is_older_n) begin
                commands[6 * count +: 6] = entry(REF, left_place_n, NOWHERE);
                count = count + 1'b1;
            end
            left_is_older_n = 1'b1;
            right_place_n   = right == ON_EDGE ? edge_place_n : spare_place_n;
            if (right != ON_EDGE) begin
                spare_is_left_n  = 1'b0;
                spare_is_right_n = right == INSIDE;
                spare_row_n      = right_top;
            end
            kept = NOWHERE;
            if (right != ON_OTHER && COLUMN_DEPTH > 0) begin
                if (split_column) begin
                    if (another && !split_full_n) kept = TO_SPLIT;
                end else if (keeps_column && right == INSIDE && !column_full_n) begin
                    if (column_fill_n == FULL) column_full_n = 1'b1;
                    else kept = TO_COLUMN;
                end
            end
            if (right != ON_OTHER && split_column && second && split_fill_n != '0) begin
                split_fill_n = split_fill_n - 1'b1;
                commands[6 * count +: 6] = entry(SPLIT, right_place_n, NOWHERE);
            end else begin
                commands[6 * count +: 6] = entry(NEW, right_place_n, kept);
                sources[3 * vertex_count +: 3] =
                    right != ON_EDGE ? S_TR : left == ON_EDGE ? S_EDGE1 : S_EDGE;
                vertex_count = vertex_count + 1'b1;
                if (kept == TO_SPLIT) begin
                    split_fill_n = split_fill_n + 1'b1;
                    split_full_n = split_fill_n == FULL;
                end else if (kept == TO_COLUMN) begin
                    column_fill_n = column_fill_n + 1'b1;
                    kept_right_n  = kept_right_n + 1'b1;
                    keep_right    = 1'b1;
                end
            end
            count = count + 1'b1;
        end

        // Ears: e0 bl e1 as a strip, and bl again before each further edge point; then br.
        if (kind == 3'd1) begin
            init       = 1'b1;
            init_flip  = flip;
            commands[0 +: 6] = entry(edge_sent ? REF : NEW, edge_place, NOWHERE);
            commands[6 +: 6] = entry(REF, left_place, NOWHERE);
            commands[12 +: 6] = entry(NEW, spare_place, NOWHERE);
            count        = 3'd3;
            sources      = edge_sent ? {9'd0, S_EDGE1} : {6'd0, S_EDGE1, S_EDGE};
            vertex_count = edge_sent ? 3'd1 : 3'd2;
        end
        if (kind == 3'd2 || kind == 3'd3) begin
            commands[0 +: 6] = entry(REF, left_place, NOWHERE);
            commands[6 +: 6] = kind == 3'd2 ? entry(NEW, spare_place, NOWHERE)
                                            : entry(REF, right_place, NOWHERE);
            count        = 3'd2;
            sources      = {9'd0, S_EDGE};
            vertex_count = kind == 3'd2 ? 3'd1 : 3'd0;
        end
        if (kind == 3'd1 || kind == 3'd2) begin
            spare_place_n = edge_place;
            edge_place_n  = spare_place;
        end
    end
endmodule

`default_nettype wire
