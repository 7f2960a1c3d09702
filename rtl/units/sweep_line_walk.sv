`default_nettype none

// The side walk (Gumhold and Huettner 1999, section 3.4.4) on slots: which side of the strip moves
// up, onto what, and when a column ends. Slots advance exactly, so it is the same for all kinds of
// adder. One beat a cycle; a half's last beat loads the next half, so nothing is lost between
// columns, halves and base triangles.
module sweep_line_walk #(
    parameter integer HW  = 217,        // bits of a half's description, see sweep_line_halves
    parameter integer ROW = 15          // bits of a side coordinate: +-4096, and a row beyond
) (
    input  wire           clk,
    input  wire           rst_n,
    input  wire           abort_all,

    input  wire           half_valid,   // the next half
    output wire           half_ready,
    input  wire [HW-1:0]  half,
    input  wire [4*ROW+45:0] initial_slots,

    output wire           out_valid,    // a beat, or (kind 5) none: the edge only advances
    input  wire           out_ready,
    output wire [2:0]     kind,         // see sweep_line_commands
    output wire           first,
    output wire           right_first,
    output wire [1:0]     left, right,
    output wire [ROW-1:0] left_top, right_top,
    output wire           edge_sent,    // the edge's vertex is in a strip register
    output wire           column_end,
    output wire           edge_moves,   // the edge advances, and not beyond its end
    output wire           give_up,      // end the base triangle with an empty beat
    output wire           runaway,      // because a column took too many steps
    output wire           item_end,     // the last beat of a base triangle
    output wire           load_fresh,   // the half that is loaded starts a walk,
    output wire           load_item,    //   a base triangle
    output wire           half_start,   // the first beat of the half,
    output wire           walk_start,   //   of the walk along the primary edge
    output reg            edge_moved,   // the half's first edge point is not the edge's start
    output wire           crosses,      // Vstart gets into another row,
    output wire           falls,        //   a lower one
    output wire           next_crosses, // it will a column on
    output wire           column_ahead, // another column of this half follows
    output wire [HW-1:0]  current,      // the half's description
    output wire           last_column,
    output wire           other_left,   // this left column is the other half's edge
    output wire           other_right,
    output wire [191:0]   names         // of what can be sent, see sweep_line_names
);
    localparam [1:0] STAY = 2'd0, ON_EDGE = 2'd2, ON_OTHER = 2'd3;

    // ---- the half -------------------------------------------------------------------------------
    reg          active;
    reg [HW-1:0] description;

    wire         h_buffer, h_second, h_walk, h_single, h_item, h_fresh, h_final, h_another;
    wire         h_continues, h_mirrored, h_down, h_flip, h_tip, h_closing, h_oleft, h_oright;
    wire [16:0]  h_limit;
    wire [13:0]  h_sweep, h_columns;
    wire [1:0]   w_edge, w_from, w_to, e_edge, e_from, e_to, o_edge, o_from, o_to;
    wire         w_backward, e_backward, o_backward;
    wire [13:0]  w_steps, w_row, e_steps, e_row0, o_steps, o_row0;
    wire [1:0]   w_quotient, e_quotient, o_quotient;
    wire [14:0]  w_rest, e_rest, o_rest;

    assign {h_buffer, h_second, h_walk, h_single, h_item, h_fresh, h_final, h_another, h_continues,
            h_mirrored, h_limit, h_sweep,
            h_columns, h_down, h_flip, h_tip, h_closing, h_oleft, h_oright,
            w_edge, w_from, w_to, w_backward, w_steps, w_row, w_quotient, w_rest,
            e_edge, e_from, e_to, e_backward, e_steps, e_row0, e_quotient, e_rest,
            o_edge, o_from, o_to, o_backward, o_steps, o_row0, o_quotient, o_rest} = description;
    assign current = description;
    // Of the half that is loaded: where its walk starts, and its columns.
    wire [13:0] half_sweep   = half[HW-28 -: 14];
    wire [13:0] half_columns = half[HW-42 -: 14];
    wire unused_fields = &{1'b0, h_buffer, h_second, h_walk, h_item, h_fresh, h_another,
                           h_continues, h_flip, h_sweep, w_row, e_row0};

    localparam integer SW = ROW + 15;    // a slot coordinate and its remainder

    // ---- state ----------------------------------------------------------------------------------
    reg          in_column, last, on_edge, right_done, started, walking;
    reg  [1:0]   ear;
    reg  [13:0]  column;                 // its number in the half
    reg  [13:0]  sweep;                  // sweep coordinate of the left column
    reg  [16:0]  steps;                  // in this column
    reg  [ROW-1:0] left_row, right_row;
    reg  [ROW-1:0] start_row;            // of Vstart,
    reg  [SW-1:0]  start_next;           //   and a column on
    reg  [13:0]  start_step;             // of Vstart on the primary edge
    reg  [SW-1:0]  other_row;
    reg  [13:0]  other_at;

    assign first         = ~in_column;
    assign half_start    = ~started;
    assign walk_start    = ~walking;
    assign last_column   = last;
    assign other_left    = h_oleft & column == '0;
    assign other_right   = h_oright & last;

    wire closes = last & h_closing;
    // Vstart two columns on: whether the base's next step crosses a row is known a column ahead.
    wire [SW-1:0] start_after;
    sweep_line_slot #(.ROW(ROW)) walk_on (
        .slot(start_next), .quotient(w_quotient), .rest(w_rest), .steps(w_steps),
        .moved(start_after)
    );
    assign crosses      = start_next[SW-1:15] != start_row;
    assign falls        = $signed(start_next[SW-1:15]) < $signed(start_row);
    assign next_crosses = start_after[SW-1:15] != start_next[SW-1:15];

    wire [ROW-1:0] row_l = first ? start_row : left_row;
    wire [ROW-1:0] row_r = first ? start_next[SW-1:15] : right_row;
    wire           edged = first ? h_tip & column == '0 : on_edge;
    wire           done  = first ? closes : right_done;
    wire [ROW-1:0] up_l  = row_l + 1'b1;
    wire [ROW-1:0] up_r  = row_r + 1'b1;
    wire [SW-1:0]  other_0 = first ? {o_row0[13], o_row0, 1'b0, o_steps} : other_row;
    wire [13:0]    other_n = first ? '0 : other_at;
    wire [SW-1:0]  other_1;
    sweep_line_slot #(.ROW(ROW)) other_on (
        .slot(other_0), .quotient(o_quotient), .rest(o_rest), .steps(o_steps), .moved(other_1)
    );
    wire           other_ends = other_n + 1'b1 == o_steps;

    // ---- handshakes -----------------------------------------------------------------------------
    wire [13:0] next_column = column + 1'b1;
    reg  dropping;                        // the rest of a triangle that was given up
    wire step = out_valid & out_ready;
    wire half_end = h_single | give_up | (column_end & next_column == h_columns);
    wire take = half_valid & half_ready;
    wire load = take & ~dropping;
    wire moves = kind == 3'd0;

    // ---- the edge -------------------------------------------------------------------------------
    wire            i_moved;
    wire [2*SW-1:0] i_edge;
    wire [ROW-1:0]  i_start;
    wire [SW-1:0]   i_next;
    assign {i_moved, i_edge, i_start, i_next} = initial_slots;

    wire [ROW-1:0] row_0, row_1;
    wire [13:0]    at_0, at_1;
    wire           edge_in_left, edge_in_right, edge1_in_left, edge1_in_right, edge_step;

    sweep_line_edge #(.ROW(ROW)) points (
        .clk(clk), .step(step), .taken(edge_step), .sent_right(right == ON_EDGE),
        .load(load), .forget(i_moved | half[HW-6]), .moved(i_moved), .slots(i_edge),
        .columns(h_columns), .steps(e_steps), .quotient(e_quotient), .rest(e_rest),
        .column(column), .next_column(next_column),
        .row(row_0), .row_1(row_1), .at(at_0), .at_1(at_1), .in_left(edge_in_left),
        .in_right(edge_in_right), .in_left_1(edge1_in_left), .in_right_1(edge1_in_right),
        .moves(edge_moves), .sent(edge_sent)
    );

    // ---- the step -------------------------------------------------------------------------------
    wire [1:0]  ear_n;
    wire        edged_n, done_n;
    wire [13:0] right_sweep = h_down ? sweep - 1'b1 : sweep + 1'b1;
    wire [16:0] steps_now   = first ? 17'd1 : steps + 1'b1;

    sweep_line_step #(.ROW(ROW)) decision (
        .abort_all(abort_all), .single(h_single), .over_limit(steps_now > h_limit),
        .ear(ear), .ear_next(ear_n), .first(first), .closes(closes),
        .other_left(other_left), .other_right(other_right), .edged(edged), .done(done),
        .left_up(up_l), .right_up(up_r), .other_up(other_1[SW-1:15]), .other_ends(other_ends),
        .edge_row(row_0), .edge_in_left(edge_in_left), .edge_in_right(edge_in_right),
        .edge1_row(row_1), .edge1_in_left(edge1_in_left), .edge1_in_right(edge1_in_right),
        .kind(kind), .right_first(right_first), .left(left), .right(right), .left_top(left_top),
        .right_top(right_top), .edged_next(edged_n), .done_next(done_n), .edge_step(edge_step),
        .column_end(column_end), .give_up(give_up), .runaway(runaway)
    );

    sweep_line_names naming (
        .single(h_single), .mirrored(h_mirrored),
        .walk({w_edge, w_from, w_to, w_backward, w_steps}),
        .edge_walk({e_edge, e_from, e_to, e_backward, e_steps}),
        .other({o_edge, o_from, o_to, o_backward, o_steps}),
        .walk_at(start_step + 1'b1), .edge_at(at_0), .edge1_at(at_1), .other_at(other_n + 1'b1),
        .left_on_other(left == ON_OTHER), .right_on_other(right == ON_OTHER),
        .left_sweep(sweep), .right_sweep(right_sweep), .left_row(up_l[13:0]),
        .right_row(up_r[13:0]), .names(names)
    );

    // ---- from beat to beat ----------------------------------------------------------------------
    assign out_valid    = active;
    assign column_ahead = next_column != h_columns;
    assign item_end     = give_up | (half_end & h_final);
    assign half_ready   = dropping | ~active | (step & half_end & (~give_up | h_final));
    assign load_item    = load & half[HW-5];
    assign load_fresh   = load & half[HW-6];

    always_ff @(posedge clk) begin
        if (!rst_n) begin
            active   <= 1'b0;
            dropping <= 1'b0;
        end else begin
            if (load) active <= 1'b1;
            else if (step & half_end) active <= 1'b0;
            dropping <= (step & give_up & ~h_final) | (dropping & ~take);
        end
    end

    always_ff @(posedge clk) begin
        if (step) begin
            started   <= 1'b1;
            walking   <= 1'b1;
            ear       <= ear_n;
            in_column <= ~column_end;
            steps     <= steps_now;
            on_edge   <= edged_n;
            right_done <= done_n;
            left_row  <= left != STAY ? left_top : row_l;
            right_row <= right != STAY ? right_top : row_r;
            if (left == ON_OTHER | right == ON_OTHER) begin
                other_row <= other_1;
                other_at  <= other_n + 1'b1;
            end else begin
                other_row <= other_0;
                other_at  <= other_n;
            end
            if (first & moves) begin
                start_row  <= start_next[SW-1:15];
                start_next <= start_after;
                start_step <= start_step + 1'b1;
            end
            if (column_end) begin
                sweep  <= right_sweep;
                column <= next_column;
                last   <= next_column + 1'b1 == h_columns;
            end
        end
        if (load) begin
            description <= half;
            started     <= 1'b0;
            in_column   <= 1'b0;
            ear         <= 2'd0;
            column      <= '0;
            last        <= half_columns == 14'd1;
            edge_moved  <= i_moved;
            if (half[HW-6]) begin
                walking    <= 1'b0;
                sweep      <= half_sweep;
                start_row  <= i_start;
                start_next <= i_next;
                start_step <= '0;
            end
        end
    end
endmodule

`default_nettype wire
