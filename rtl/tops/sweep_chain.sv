`default_nettype none

// The Verilog top behind the triangle setup: base triangles in, fine triangles of
// perspective-corrected vertices out, a beat for each step of the sweep line.
//
//   sweep_line -> rp_scatter -> steps ------------------> rp_gather -> strip
//                            -> vertices -> perspective ->
//
// A step of the sweep line carries 0..4 new vertices, and `perspective` takes one a cycle, which
// sets the pace: 0.57 vertices a fine triangle at 64 px. The queue of vertices before it evens out
// the first steps of columns, which bring several, and those that bring none.
//
// A vertex is opaque to the stripping unit: the outputs of `perspective`, in their order. An empty
// beat at the end of a base triangle means that it was given up; it flushes the stripping unit.
//
// Time: latency 20 (the first step, of three vertices), in_ready is a register.
module sweep_chain #(
`include "rtl/tops/sweep_chain_params.svh"
    // Vertices that wait for `perspective`, steps on their way, and vertices that wait for theirs.
    , parameter integer SCATTER_DEPTH = 32
    , parameter integer STEPS_DEPTH   = 64
    , parameter integer GATHER_DEPTH  = 8
    // Not to be set: components; bits of one, of its accumulator, and of a corrected vertex.
    , parameter integer C  = COMPONENTS
    , parameter integer DW = SWEEP_DATA_WIDTH > INVERSE_W_WIDTH ? SWEEP_DATA_WIDTH
                                                                : INVERSE_W_WIDTH
    , parameter integer VW = DW + GUARD_BITS
    , parameter integer FW = 3*POSITION_WIDTH + 6*UNNORMALISED_WIDTH + 2*UV_WIDTH + 2
) (
    input  wire                         clk,
    input  wire                         rst_n,         // synchronous, low

    // Registers, stable while base triangles are inside.
    input  wire                         abort_all,     // end every triangle at once
    input  wire                         tangents,      // vertices have tangents

    // A base triangle: see sweep_line.
    input  wire                         in_valid,
    output wire                         in_ready,
    input  wire                         single,
    input  wire                         continues,
    input  wire                         mirrored,
    input  wire [13:0]                  sweep_start,
    input  wire [26:0]                  determinant,
    input  wire [16:0]                  step_limit,
    input  wire [13:0]                  half0_columns,
    input  wire                         half0_down,
    input  wire                         half0_flip,
    input  wire                         half0_tip,
    input  wire                         half0_closing,
    input  wire                         half0_other_left,
    input  wire                         half0_other_right,
    input  wire [13:0]                  half1_columns,
    input  wire                         half1_down,
    input  wire                         half1_flip,
    input  wire                         half1_tip,
    input  wire                         half1_closing,
    input  wire                         half1_other_left,
    input  wire                         half1_other_right,
    input  wire [1:0]                   walk0_edge,
    input  wire [1:0]                   walk0_from,
    input  wire [1:0]                   walk0_to,
    input  wire                         walk0_backward,
    input  wire [13:0]                  walk0_steps,
    input  wire [13:0]                  walk0_row,
    input  wire [1:0]                   walk0_row_quotient,
    input  wire [14:0]                  walk0_row_rest,
    input  wire [1:0]                   walk1_edge,
    input  wire [1:0]                   walk1_from,
    input  wire [1:0]                   walk1_to,
    input  wire                         walk1_backward,
    input  wire [13:0]                  walk1_steps,
    input  wire [13:0]                  walk1_row,
    input  wire [1:0]                   walk1_row_quotient,
    input  wire [14:0]                  walk1_row_rest,
    input  wire [1:0]                   edge0_edge,
    input  wire [1:0]                   edge0_from,
    input  wire [1:0]                   edge0_to,
    input  wire                         edge0_backward,
    input  wire [13:0]                  edge0_steps,
    input  wire [13:0]                  edge0_row,
    input  wire [1:0]                   edge0_row_quotient,
    input  wire [14:0]                  edge0_row_rest,
    input  wire [1:0]                   edge1_edge,
    input  wire [1:0]                   edge1_from,
    input  wire [1:0]                   edge1_to,
    input  wire                         edge1_backward,
    input  wire [13:0]                  edge1_steps,
    input  wire [13:0]                  edge1_row,
    input  wire [1:0]                   edge1_row_quotient,
    input  wire [14:0]                  edge1_row_rest,
    input  wire [C*DW-1:0]              corner0,
    input  wire [C*DW-1:0]              corner1,
    input  wire [C*DW-1:0]              corner2,
    input  wire [C*VW-1:0]              walk0_start,
    input  wire [C*VW-1:0]              walk0_step,
    input  wire [C*15-1:0]              walk0_rest,
    input  wire [C*VW-1:0]              walk1_start,
    input  wire [C*VW-1:0]              walk1_step,
    input  wire [C*15-1:0]              walk1_rest,
    input  wire [C*VW-1:0]              edge0_start,
    input  wire [C*VW-1:0]              edge0_step,
    input  wire [C*15-1:0]              edge0_rest,
    input  wire [C*VW-1:0]              edge1_start,
    input  wire [C*VW-1:0]              edge1_step,
    input  wire [C*15-1:0]              edge1_rest,
    input  wire [C*VW-1:0]              base0,
    input  wire [C*VW-1:0]              base1,
    input  wire [C*VW-1:0]              sweep_step,
    input  wire [C*27-1:0]              sweep_rest,
    input  wire [C*VW-1:0]              side_step,
    input  wire [C*27-1:0]              side_rest,

    // What a step made, and whether it is the base triangle's last. Vertices are {x, y, z,
    // nx, ny, nz, uv_x, uv_y, tx, ty, tz, left_handed, clamped}; undefined if not made.
    output wire                         out_valid,
    input  wire                         out_ready,
    output wire [FW-1:0]                a1,            // the second triangle
    output wire [FW-1:0]                b1,
    output wire [FW-1:0]                c1,
    output wire [FW-1:0]                a0,            // the first
    output wire [FW-1:0]                b0,
    output wire [FW-1:0]                c0,
    output wire [1:0]                   triangles,     // made, 0..2
    output wire                         bad_ref,       // a command could not be carried out
    output wire                         runaway,       // the base triangle is given up
    output wire                         last
);
    localparam integer SD = SWEEP_DATA_WIDTH;
    localparam integer PD = POSITION_WIDTH;
    localparam integer UD = UNNORMALISED_WIDTH;
    localparam integer IW = 4*6 + 3 + 4;               // a step without its vertices

    // ---- sweep line -----------------------------------------------------------------------------
    wire            sweep_valid, sweep_ready;
    wire [C*DW-1:0] data3, data2, data1, data0;
    wire [31:0]     name3, name2, name1, name0;
    wire [5:0]      sent3, sent2, sent1, sent0;        // commands
    wire [2:0]      sent_count, vertex_count;
    wire            sent_init, sent_flip, sent_runaway, sent_last;
    wire            unused_status;

    sweep_line #(
        .SWEEP_DATA_WIDTH(SWEEP_DATA_WIDTH), .SWEEP_DATA_FRAC(SWEEP_DATA_FRAC),
        .INVERSE_W_WIDTH(INVERSE_W_WIDTH), .INVERSE_W_FRAC(INVERSE_W_FRAC),
        .ADDER_KIND(ADDER_KIND), .GUARD_BITS(GUARD_BITS), .COLUMN_DEPTH(COLUMN_DEPTH),
        .COMPONENTS(COMPONENTS)
    ) sweep (
        .clk(clk), .rst_n(rst_n), .abort_all(abort_all), .runaway_seen(unused_status),
        .in_valid(in_valid), .in_ready(in_ready),
`include "rtl/units/sweep_line_item.svh"
        .out_valid(sweep_valid), .out_ready(sweep_ready),
        .data3(data3), .kind3(name3[31:30]), .part3(name3[29:28]), .a3(name3[27:14]),
        .b3(name3[13:0]),
        .data2(data2), .kind2(name2[31:30]), .part2(name2[29:28]), .a2(name2[27:14]),
        .b2(name2[13:0]),
        .data1(data1), .kind1(name1[31:30]), .part1(name1[29:28]), .a1(name1[27:14]),
        .b1(name1[13:0]),
        .data0(data0), .kind0(name0[31:30]), .part0(name0[29:28]), .a0(name0[27:14]),
        .b0(name0[13:0]),
        .command3(sent3), .command2(sent2), .command1(sent1), .command0(sent0),
        .count(sent_count), .vertex_count(vertex_count), .init(sent_init), .flip(sent_flip),
        .runaway(sent_runaway), .last(sent_last)
    );
    wire unused_names = &{1'b0, name3, name2, name1, name0};

    // ---- vertices apart from their steps --------------------------------------------------------
    wire            step_valid, step_ready;
    wire [IW-1:0]   step;
    wire [2:0]      step_n;
    wire            vertex_valid, vertex_ready;
    wire [C*DW-1:0] vertex;

    rp_scatter #(.IW(IW), .W(C*DW), .D(SCATTER_DEPTH), .N(4)) scatter (
        .clk(clk), .rst_n(rst_n),
        .in_valid(sweep_valid), .in_ready(sweep_ready),
        .in_item({sent3, sent2, sent1, sent0, sent_count, sent_init, sent_flip, sent_runaway,
                  sent_last}),
        .in_n(vertex_count), .in_parts({data3, data2, data1, data0}),
        .item_valid(step_valid), .item_ready(step_ready), .item(step), .item_n(step_n),
        .part_valid(vertex_valid), .part_ready(vertex_ready), .part(vertex)
    );

    // ---- perspective ----------------------------------------------------------------------------
    // A component has a place of DW bits. Without tangents there are nine.
    wire [13*DW-1:0] places;
    wire             fine_valid, fine_ready;
    wire [PD-1:0]    x, y, z;
    wire [UD-1:0]    nx, ny, nz, tx, ty, tz;
    wire [UV_WIDTH-1:0] uv_x, uv_y;
    wire             left_handed, clamped;

    genvar i;
    generate
        for (i = 0; i < 13; i = i + 1) begin : g_place
            if (i < C) assign places[i*DW +: DW] = vertex[i*DW +: DW];
            else assign places[i*DW +: DW] = '0;
        end
    endgenerate

    perspective #(
        .UV_WIDTH(UV_WIDTH), .UV_FRAC(UV_FRAC), .POSITION_WIDTH(POSITION_WIDTH),
        .POSITION_FRAC(POSITION_FRAC), .UNNORMALISED_WIDTH(UNNORMALISED_WIDTH),
        .UNNORMALISED_FRAC(UNNORMALISED_FRAC), .SWEEP_DATA_WIDTH(SWEEP_DATA_WIDTH),
        .SWEEP_DATA_FRAC(SWEEP_DATA_FRAC), .INVERSE_W_WIDTH(INVERSE_W_WIDTH),
        .INVERSE_W_FRAC(INVERSE_W_FRAC), .COMPONENTS(COMPONENTS),
        .RECIPROCAL_INDEX_BITS(RECIPROCAL_INDEX_BITS),
        .RECIPROCAL_NEWTON_STEPS(RECIPROCAL_NEWTON_STEPS), .RECIPROCAL_BITS(RECIPROCAL_BITS)
    ) correction (
        .clk(clk), .rst_n(rst_n), .tangents(tangents),
        .in_valid(vertex_valid), .in_ready(vertex_ready),
        .x_c(places[0*DW +: SD]), .y_c(places[1*DW +: SD]), .z_c(places[2*DW +: SD]),
        .nx_c(places[3*DW +: SD]), .ny_c(places[4*DW +: SD]), .nz_c(places[5*DW +: SD]),
        .uv_x_c(places[6*DW +: SD]), .uv_y_c(places[7*DW +: SD]),
        .c(places[8*DW +: INVERSE_W_WIDTH]),
        .tx_c(places[9*DW +: SD]), .ty_c(places[10*DW +: SD]), .tz_c(places[11*DW +: SD]),
        .handedness_c(places[12*DW +: SD]),
        .out_valid(fine_valid), .out_ready(fine_ready),
        .x(x), .y(y), .z(z), .nx(nx), .ny(ny), .nz(nz), .uv_x(uv_x), .uv_y(uv_y),
        .tx(tx), .ty(ty), .tz(tz), .left_handed(left_handed), .clamped(clamped)
    );
    wire unused_places = &{1'b0, places};              // a component may be narrower than its place

    // ---- steps with their vertices --------------------------------------------------------------
    wire            whole_valid, whole_ready;
    wire [IW-1:0]   whole;
    wire [2:0]      unused_n;
    wire [4*FW-1:0] vertices;

    rp_gather #(.IW(IW), .W(FW), .DI(STEPS_DEPTH), .D(GATHER_DEPTH), .N(4)) gather (
        .clk(clk), .rst_n(rst_n),
        .item_valid(step_valid), .item_ready(step_ready), .item(step), .item_n(step_n),
        .part_valid(fine_valid), .part_ready(fine_ready),
        .part({x, y, z, nx, ny, nz, uv_x, uv_y, tx, ty, tz, left_handed, clamped}),
        .out_valid(whole_valid), .out_ready(whole_ready), .out_item(whole), .out_n(unused_n),
        .out_parts(vertices)
    );

    wire [5:0] command3, command2, command1, command0;
    wire [2:0] count;
    wire       init, flip, given_up, ends;
    assign {command3, command2, command1, command0, count, init, flip, given_up, ends} = whole;

    strip #(.COLUMN_DEPTH(COLUMN_DEPTH), .VERTEX_WIDTH(FW)) stripping (
        .clk(clk), .rst_n(rst_n), .in_valid(whole_valid), .in_ready(whole_ready),
        .flush(ends & (count == 3'd0)), .init(init), .flip(flip), .count(count),
        .command0(command0), .command1(command1), .command2(command2), .command3(command3),
        .vertex0(vertices[0*FW +: FW]), .vertex1(vertices[1*FW +: FW]),
        .vertex2(vertices[2*FW +: FW]), .vertex3(vertices[3*FW +: FW]),
        .out_valid(out_valid), .out_ready(out_ready), .triangles(triangles), .bad_ref(bad_ref),
        .a0(a0), .b0(b0), .c0(c0), .a1(a1), .b1(b1), .c1(c1)
    );

    // Beside the stripping unit: one stage as there, so both are full at the same time.
    wire unused_valid, unused_ready, unused_load;
    rp_pipe #(.W(2), .L(1)) marks (
        .clk(clk), .rst_n(rst_n), .in_valid(whole_valid), .in_ready(unused_ready),
        .in_data({given_up, ends}), .out_valid(unused_valid), .out_ready(out_ready),
        .out_data({runaway, last}), .load(unused_load)
    );
endmodule

`default_nettype wire
