`default_nettype none

module sweep_line_replay #(
`include "rtl/units/sweep_line_params.svh"
    , parameter integer COUNT = 1
    , parameter integer BEATS = 1
);
    localparam integer C  = COMPONENTS;
    localparam integer DW = SWEEP_DATA_WIDTH > INVERSE_W_WIDTH ? SWEEP_DATA_WIDTH
                                                               : INVERSE_W_WIDTH;
    localparam integer VW = DW + GUARD_BITS;
    localparam integer IW = 309 + 3*C*DW + 12*C*VW + 4*C*15 + 2*C*27;
    localparam integer NW = C*DW + 32;          // a vertex
    localparam integer OW = 4*NW + 24 + 10;

    wire          clk, rst_n, in_valid, in_ready, out_valid, out_ready, abort_all;
    wire [IW:0]   line;
    wire [31:0]   unused_eagerness;
    wire          unused_runaway;

    wire          single, continues, mirrored;
    wire [13:0]   sweep_start;
    wire [26:0]   determinant;
    wire [16:0]   step_limit;
    wire [13:0]   half0_columns;
    wire          half0_down, half0_flip, half0_tip, half0_closing;
    wire          half0_other_left, half0_other_right;
    wire [13:0]   half1_columns;
    wire          half1_down, half1_flip, half1_tip, half1_closing;
    wire          half1_other_left, half1_other_right;
    wire [1:0]    walk0_edge, walk0_from, walk0_to, walk0_row_quotient;
    wire          walk0_backward;
    wire [13:0]   walk0_steps, walk0_row;
    wire [14:0]   walk0_row_rest;
    wire [C*VW-1:0] walk0_start, walk0_step;
    wire [C*15-1:0] walk0_rest;
    wire [1:0]    walk1_edge, walk1_from, walk1_to, walk1_row_quotient;
    wire          walk1_backward;
    wire [13:0]   walk1_steps, walk1_row;
    wire [14:0]   walk1_row_rest;
    wire [C*VW-1:0] walk1_start, walk1_step;
    wire [C*15-1:0] walk1_rest;
    wire [1:0]    edge0_edge, edge0_from, edge0_to, edge0_row_quotient;
    wire          edge0_backward;
    wire [13:0]   edge0_steps, edge0_row;
    wire [14:0]   edge0_row_rest;
    wire [C*VW-1:0] edge0_start, edge0_step;
    wire [C*15-1:0] edge0_rest;
    wire [1:0]    edge1_edge, edge1_from, edge1_to, edge1_row_quotient;
    wire          edge1_backward;
    wire [13:0]   edge1_steps, edge1_row;
    wire [14:0]   edge1_row_rest;
    wire [C*VW-1:0] edge1_start, edge1_step;
    wire [C*15-1:0] edge1_rest;
    wire [C*DW-1:0] corner0, corner1, corner2;
    wire [C*VW-1:0] base0, base1, sweep_step, side_step;
    wire [C*27-1:0] sweep_rest, side_rest;

    wire [C*DW-1:0] data0, data1, data2, data3;
    wire [1:0]    kind0, kind1, kind2, kind3, part0, part1, part2, part3;
    wire [13:0]   a0, a1, a2, a3, b0, b1, b2, b3;
    wire [5:0]    command0, command1, command2, command3;
    wire [2:0]    count, vertex_count;
    wire          init, flip, runaway, last;

    // Of the vertices, only those that the beat has mean anything.
    wire [4*NW-1:0] vertices = {{data3, kind3, part3, a3, b3} & {NW{vertex_count > 3'd3}},
                                {data2, kind2, part2, a2, b2} & {NW{vertex_count > 3'd2}},
                                {data1, kind1, part1, a1, b1} & {NW{vertex_count > 3'd1}},
                                {data0, kind0, part0, a0, b0} & {NW{vertex_count > 3'd0}}};

    replay_beats #(.COUNT(COUNT), .BEATS(BEATS), .RW(1), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready), .out_valid(out_valid), .out_ready(out_ready),
        .out_bits({vertices, command3, command2, command1, command0, count, vertex_count,
                   init, flip, runaway, last}),
        .out_last(last), .eagerness(unused_eagerness)
    );

    assign {abort_all,
        single, continues, mirrored, sweep_start, determinant, step_limit, half0_columns,
        half0_down, half0_flip, half0_tip, half0_closing, half0_other_left, half0_other_right,
        half1_columns, half1_down, half1_flip, half1_tip, half1_closing, half1_other_left,
        half1_other_right, walk0_edge, walk0_from, walk0_to, walk0_backward, walk0_steps,
        walk0_row, walk0_row_quotient, walk0_row_rest, walk1_edge, walk1_from, walk1_to,
        walk1_backward, walk1_steps, walk1_row, walk1_row_quotient, walk1_row_rest, edge0_edge,
        edge0_from, edge0_to, edge0_backward, edge0_steps, edge0_row, edge0_row_quotient,
        edge0_row_rest, edge1_edge, edge1_from, edge1_to, edge1_backward, edge1_steps, edge1_row,
        edge1_row_quotient, edge1_row_rest,
        corner0, corner1, corner2, walk0_start, walk0_step, walk0_rest, walk1_start, walk1_step,
        walk1_rest, edge0_start, edge0_step, edge0_rest, edge1_start, edge1_step, edge1_rest,
        base0, base1, sweep_step, sweep_rest, side_step, side_rest} = line;

    sweep_line #(
        .SWEEP_DATA_WIDTH(SWEEP_DATA_WIDTH), .INVERSE_W_WIDTH(INVERSE_W_WIDTH),
        .ADDER_KIND(ADDER_KIND), .GUARD_BITS(GUARD_BITS), .COLUMN_DEPTH(COLUMN_DEPTH),
        .COMPONENTS(COMPONENTS)
    ) unit (
        .clk(clk), .rst_n(rst_n), .abort_all(abort_all), .runaway_seen(unused_runaway),
        .in_valid(in_valid), .in_ready(in_ready), .out_valid(out_valid), .out_ready(out_ready),
        .single(single), .continues(continues), .mirrored(mirrored), .sweep_start(sweep_start),
        .determinant(determinant), .step_limit(step_limit), .half0_columns(half0_columns),
        .half0_down(half0_down), .half0_flip(half0_flip), .half0_tip(half0_tip),
        .half0_closing(half0_closing), .half0_other_left(half0_other_left),
        .half0_other_right(half0_other_right), .half1_columns(half1_columns),
        .half1_down(half1_down), .half1_flip(half1_flip), .half1_tip(half1_tip),
        .half1_closing(half1_closing), .half1_other_left(half1_other_left),
        .half1_other_right(half1_other_right), .walk0_edge(walk0_edge), .walk0_from(walk0_from),
        .walk0_to(walk0_to), .walk0_backward(walk0_backward), .walk0_steps(walk0_steps),
        .walk0_row(walk0_row), .walk0_row_quotient(walk0_row_quotient),
        .walk0_row_rest(walk0_row_rest), .walk1_edge(walk1_edge), .walk1_from(walk1_from),
        .walk1_to(walk1_to), .walk1_backward(walk1_backward), .walk1_steps(walk1_steps),
        .walk1_row(walk1_row), .walk1_row_quotient(walk1_row_quotient),
        .walk1_row_rest(walk1_row_rest), .edge0_edge(edge0_edge), .edge0_from(edge0_from),
        .edge0_to(edge0_to), .edge0_backward(edge0_backward), .edge0_steps(edge0_steps),
        .edge0_row(edge0_row), .edge0_row_quotient(edge0_row_quotient),
        .edge0_row_rest(edge0_row_rest), .edge1_edge(edge1_edge), .edge1_from(edge1_from),
        .edge1_to(edge1_to), .edge1_backward(edge1_backward), .edge1_steps(edge1_steps),
        .edge1_row(edge1_row), .edge1_row_quotient(edge1_row_quotient),
        .edge1_row_rest(edge1_row_rest),
        .corner0(corner0), .corner1(corner1), .corner2(corner2), .walk0_start(walk0_start),
        .walk0_step(walk0_step), .walk0_rest(walk0_rest), .walk1_start(walk1_start),
        .walk1_step(walk1_step), .walk1_rest(walk1_rest), .edge0_start(edge0_start),
        .edge0_step(edge0_step), .edge0_rest(edge0_rest), .edge1_start(edge1_start),
        .edge1_step(edge1_step), .edge1_rest(edge1_rest), .base0(base0), .base1(base1),
        .sweep_step(sweep_step), .sweep_rest(sweep_rest), .side_step(side_step),
        .side_rest(side_rest),
        .data0(data0), .data1(data1), .data2(data2), .data3(data3), .kind0(kind0), .kind1(kind1),
        .kind2(kind2), .kind3(kind3), .part0(part0), .part1(part1), .part2(part2), .part3(part3),
        .a0(a0), .a1(a1), .a2(a2), .a3(a3), .b0(b0), .b1(b1), .b2(b2), .b3(b3),
        .command0(command0), .command1(command1), .command2(command2), .command3(command3),
        .count(count), .vertex_count(vertex_count), .init(init), .flip(flip), .runaway(runaway),
        .last(last)
    );
endmodule

`default_nettype wire
