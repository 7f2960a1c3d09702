`default_nettype none

// The sweep line (Gumhold and Huettner 1999, section 3.4.4): remeshes base triangles with additions
// and comparisons alone. An item is a base triangle as triangle_setup leaves it; each step of the
// side walk leaves as a beat of up to four commands for the stripping unit, with its new vertices.
//
//   items -> two buffers -> sweep_line_halves -> sweep_line_walk, sweep_line_send -> data -> out
//
// Control works on slots alone; vertex data follow a stage behind, in two lanes (sweep_line_two: a
// beat a cycle) or, with COLUMN_DEPTH = 0, in one (sweep_line_one: an addition a cycle).
//
// A triangle that is aborted, or in which a column takes more than step_limit steps, ends with an
// empty beat; the stripping unit must then be flushed.
//
// Time: latency 5, in_ready is a register.
module sweep_line #(
`include "rtl/units/sweep_line_params.svh"
    , parameter integer C  = COMPONENTS
    , parameter integer DW = SWEEP_DATA_WIDTH > INVERSE_W_WIDTH ? SWEEP_DATA_WIDTH
                                                                : INVERSE_W_WIDTH
    , parameter integer VW = DW + GUARD_BITS
) (
    input  wire              clk,
    input  wire              rst_n,           // synchronous, low
    input  wire              abort_all,       // end every triangle at once
    output reg               runaway_seen,    // status: some triangle was given up

    input  wire              in_valid,
    output wire              in_ready,
    input  wire              single, continues, mirrored,
    input  wire [13:0]       sweep_start,
    input  wire [26:0]       determinant,
    input  wire [16:0]       step_limit,

    // Halves.
    input  wire [13:0]       half0_columns,
    input  wire              half0_down, half0_flip, half0_tip, half0_closing,
    input  wire              half0_other_left, half0_other_right,
    input  wire [13:0]       half1_columns,
    input  wire              half1_down, half1_flip, half1_tip, half1_closing,
    input  wire              half1_other_left, half1_other_right,

    // Walks along the primary edge, and the halves' other edges, in slots.
    input  wire [1:0]        walk0_edge, walk0_from, walk0_to, walk0_row_quotient,
    input  wire [13:0]       walk0_steps, walk0_row,
    input  wire [1:0]        walk1_edge, walk1_from, walk1_to, walk1_row_quotient,
    input  wire [13:0]       walk1_steps, walk1_row,
    input  wire [1:0]        edge0_edge, edge0_from, edge0_to, edge0_row_quotient,
    input  wire [13:0]       edge0_steps, edge0_row,
    input  wire [1:0]        edge1_edge, edge1_from, edge1_to, edge1_row_quotient,
    input  wire [13:0]       edge1_steps, edge1_row,
    input  wire [14:0]       walk0_row_rest, walk1_row_rest, edge0_row_rest, edge1_row_rest,
    input  wire              walk0_backward, walk1_backward, edge0_backward, edge1_backward,

    // Vertex data: corners, then accumulators at their start and differences with remainders.
    input  wire [C*DW-1:0]   corner0, corner1, corner2,
    input  wire [C*VW-1:0]   walk0_start, walk0_step,
    input  wire [C*15-1:0]   walk0_rest,
    input  wire [C*VW-1:0]   walk1_start, walk1_step,
    input  wire [C*15-1:0]   walk1_rest,
    input  wire [C*VW-1:0]   edge0_start, edge0_step,
    input  wire [C*15-1:0]   edge0_rest,
    input  wire [C*VW-1:0]   edge1_start, edge1_step,
    input  wire [C*15-1:0]   edge1_rest,
    input  wire [C*VW-1:0]   base0, base1, sweep_step, side_step,
    input  wire [C*27-1:0]   sweep_rest, side_rest,

    output wire              out_valid,
    input  wire              out_ready,
    output reg  [C*DW-1:0]   data3, data2, data1, data0,     // vertices: data,
    output wire [1:0]        kind3, kind2, kind1, kind0,     //   and names
    output wire [1:0]        part3, part2, part1, part0,
    output wire [13:0]       a3, a2, a1, a0,
    output wire [13:0]       b3, b2, b1, b0,
    output wire [5:0]        command3, command2, command1, command0,
    output wire [2:0]        count, vertex_count,
    output wire              init, flip, runaway, last
);
    localparam integer SW  = 309;              // scalars of an item
    localparam integer XW  = 3*C*DW + 12*C*VW + 4*C*15 + 2*C*27;  // vectors of an item
    localparam integer EXACT = (ADDER_KIND == 2) ? 1 : 0;
    localparam integer UW  = 199;              // a beat of control

    wire [SW-1:0] scalars = {
`include "rtl/units/sweep_line_scalars.svh"
    };
    wire [XW-1:0] vectors = {
`include "rtl/units/sweep_line_vectors.svh"
    };

    // ---- two items ------------------------------------------------------------------------------
    reg  [1:0]      busy;                      // a buffer holds an item,
    reg  [1:0]      waiting;                   //   of which some half is still to come
    reg             fill;                      // where the next item goes
    reg  [2*SW-1:0] items;
    wire [1:0]      halves_done;
    wire            release_item;              // the last beat of an item leaves the data stage
    wire            released;                  // its buffer
    wire            accept = in_valid & in_ready;
    wire [1:0]      accepted = {accept & fill, accept & ~fill};
    wire [1:0]      released_both = {release_item & released, release_item & ~released};

    assign in_ready = fill ? ~busy[1] : ~busy[0];

    always_ff @(posedge clk) begin
        if (!rst_n) begin
            busy    <= 2'd0;
            waiting <= 2'd0;
            fill    <= 1'b0;
        end else begin
            busy    <= (busy | accepted) & ~released_both;
            waiting <= (waiting | accepted) & ~halves_done;
            fill    <= fill ^ accept;
        end
    end

    always_ff @(posedge clk) begin
        if (accepted[0]) items[0 +: SW] <= scalars;
        if (accepted[1]) items[SW +: SW] <= scalars;
    end

    // ---- control --------------------------------------------------------------------------------
    wire          walk_valid, walk_ready, beat_valid, beat_ready, unused_taken;
    wire [UW-1:0] beat, held;                  // made, and in the data stage

    sweep_line_control #(.SW(SW), .UW(UW), .COLUMN_DEPTH(COLUMN_DEPTH)) control (
        .clk(clk), .rst_n(rst_n), .abort_all(abort_all), .waiting(waiting),
        .halves_done(halves_done), .items(items), .walk_valid(walk_valid),
        .walk_ready(walk_ready), .beat(beat)
    );

    rp_pipe #(.W(UW), .L(1)) control_stage (
        .clk(clk), .rst_n(rst_n), .in_valid(walk_valid), .in_ready(walk_ready), .in_data(beat),
        .out_valid(beat_valid), .out_ready(beat_ready), .out_data(held), .load(unused_taken)
    );

    // ---- data -----------------------------------------------------------------------------------
    wire        d_emit, d_end, d_buffer, d_second, d_walk, d_first, d_half_start, d_walk_start;
    wire        d_down, d_crosses, d_falls, d_next_crosses, d_column_end, d_ahead, d_moved;
    wire        d_edge_step, d_left_add, d_right_add, d_other_left, d_other_right, d_from_fifo;
    wire        d_keep_right, d_init, d_flip, d_runaway;
    wire [1:0]  d_left, d_right;
    wire [11:0] d_sources;
    wire [23:0] d_commands;
    wire [2:0]  d_count, d_vertices;
    wire [127:0] d_names;
    assign {d_emit, d_end, d_buffer, d_second, d_walk, d_first, d_half_start, d_walk_start,
            d_down, d_crosses, d_falls, d_next_crosses, d_column_end, d_ahead, d_moved,
            d_edge_step, d_left, d_right, d_left_add, d_right_add, d_other_left, d_other_right,
            d_from_fifo, d_keep_right, d_sources, d_commands, d_count, d_vertices, d_init, d_flip,
            d_runaway, d_names} = held;

    // A beat leaves the data stage when its additions are done; one that sends nothing just goes.
    wire out_stage_ready, out_load, data_done;
    assign beat_ready = data_done & (~d_emit | out_stage_ready);
    wire data_step    = beat_valid & beat_ready;
    assign release_item = data_step & d_end;
    assign released     = d_buffer;

    wire [3*C*DW-1:0] corners;
    wire [5*C*VW-1:0] values;
    wire [55:0] in_steps = {walk0_steps, walk1_steps, edge0_steps, edge1_steps};

    generate
        if (COLUMN_DEPTH > 0) begin : g_two
            // The first step of a walk: half a modulus and the rest may reach the next row.
            wire        carry0 = walk0_row_rest >= {1'b0, walk0_steps};
            wire        carry1 = walk1_row_rest >= {1'b0, walk1_steps};
            wire        empty0 = half0_columns == '0;
            wire [5:0]  prepare = {
                half1_tip | half1_other_left, half0_tip | half0_other_left,
                empty0 ? half1_down & continues : half0_down, walk0_row_quotient[1],
                walk1_row_quotient[0] ^ carry1, walk0_row_quotient[0] ^ carry0};
            wire        unused_fields = &{1'b0, d_crosses, d_falls, d_column_end, d_ahead, d_moved,
                                          d_left, d_right};

            assign data_done = 1'b1;
            sweep_line_two #(.C(C), .VW(VW), .DW(DW), .EXACT(EXACT), .XW(XW)) data (
                .clk(clk), .accept(accept), .fill(fill), .vectors(vectors), .in_steps(in_steps),
                .in_determinant(determinant), .prepare(prepare),
                .step(data_step), .buffer(d_buffer), .second(d_second), .walk(d_walk),
                .first(d_first), .half_start(d_half_start), .walk_start(d_walk_start),
                .down(d_down), .next_crosses(d_next_crosses), .edge_step(d_edge_step),
                .left_add(d_left_add), .right_add(d_right_add), .other_left(d_other_left),
                .other_right(d_other_right), .from_fifo(d_from_fifo), .keep_right(d_keep_right),
                .corners(corners), .values(values)
            );
        end else begin : g_one
            wire unused_fields = &{1'b0, d_next_crosses, d_left_add, d_right_add, d_from_fifo,
                                   d_keep_right};

            sweep_line_one #(.C(C), .VW(VW), .DW(DW), .EXACT(EXACT), .XW(XW)) data (
                .clk(clk), .rst_n(rst_n), .accept(accept), .fill(fill), .vectors(vectors),
                .in_steps(in_steps), .in_determinant(determinant),
                .valid(beat_valid), .step(data_step), .done(data_done), .buffer(d_buffer),
                .second(d_second), .walk(d_walk), .first(d_first), .half_start(d_half_start),
                .walk_start(d_walk_start), .column_end(d_column_end), .column_ahead(d_ahead),
                .down(d_down), .crosses(d_crosses), .falls(d_falls), .edge_moved(d_moved),
                .edge_step(d_edge_step), .left(d_left), .right(d_right),
                .other_left(d_other_left), .other_right(d_other_right),
                .corners(corners), .values(values)
            );
        end
    endgenerate

    // ---- out ------------------------------------------------------------------------------------
    rp_pipe #(.W(162), .L(1)) out_stage (
        .clk(clk), .rst_n(rst_n), .in_valid(beat_valid & data_done & d_emit),
        .in_ready(out_stage_ready),
        .in_data({d_names, d_commands, d_count, d_vertices, d_init, d_flip, d_runaway, d_end}),
        .out_valid(out_valid), .out_ready(out_ready),
        .out_data({kind3, part3, a3, b3, kind2, part2, a2, b2, kind1, part1, a1, b1,
                   kind0, part0, a0, b0, command3, command2, command1, command0,
                   count, vertex_count, init, flip, runaway, last}),
        .load(out_load)
    );

    genvar k;
    generate
        for (k = 0; k < 4; k = k + 1) begin : g_vertex
            wire [C*DW-1:0] data;
            sweep_line_vertex #(.C(C), .VW(VW), .DW(DW)) vertex (
                .is_corner(d_names[32*k + 30 +: 2] == 2'd0), .part(d_names[32*k + 28 +: 2]),
                .source(d_sources[3*k +: 3]), .corners(corners), .values(values), .data(data)
            );
        end
    endgenerate

    always_ff @(posedge clk) begin
        if (out_load)
            {data3, data2, data1, data0} <= {g_vertex[3].data, g_vertex[2].data, g_vertex[1].data,
                                             g_vertex[0].data};
        if (!rst_n) runaway_seen <= 1'b0;
        else if (out_load & d_runaway) runaway_seen <= 1'b1;
    end
endmodule

`default_nettype wire
