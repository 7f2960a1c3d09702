`default_nettype none

// Vertex data in two lanes: five adders, for Vstart, the next Vbase, Vedge and the two sides, work
// in the same cycle, a beat a cycle. Operands are chosen by what the side walk decided in the cycle
// before.
//
// The left side adds only where the column FIFO has nothing for it: on another half's edge, and
// above the last vertex that the FIFO held.
//
// Registers hold {remainder, value} of all components. Edges have remainders of 15 bits, vertices
// inside of 27, and so have the sides, which walk on either.
module sweep_line_two #(
    parameter integer C  = 13,               // components
    parameter integer VW = 32,               // bits of a value
    parameter integer DW = 32,               // bits of data
    parameter integer EXACT = 1,
    parameter integer XW = 3*C*DW + 12*C*VW + 114*C  // bits of an item's vectors
) (
    input  wire            clk,
    input  wire            accept,           // an item comes
    input  wire            fill,             // to this buffer
    input  wire [XW-1:0]   vectors,
    input  wire [55:0]     in_steps,         // of walks 0, 1 and edges 0, 1, the last in low bits
    input  wire [26:0]     in_determinant,
    input  wire [5:0]      prepare,          // {moved1, moved0, down, falls, crosses1, crosses0}

    input  wire            step,             // a beat is worked out
    input  wire            buffer,           // its item
    input  wire            second,           // its half
    input  wire            walk,             // and walk
    input  wire            first,            // it starts a column,
    input  wire            half_start,       // a half,
    input  wire            walk_start,       // a walk
    input  wire            down,             // direction of the sweep
    input  wire            next_crosses,
    input  wire            edge_step,
    input  wire            left_add,
    input  wire            right_add,
    input  wire            other_left,       // on the other half's edge
    input  wire            other_right,
    input  wire            from_fifo,
    input  wire            keep_right,
    output wire [3*C*DW-1:0] corners,        // of the item, corner 0 in the high bits
    output wire [5*C*VW-1:0] values          // right, left, edge one step on, edge, start
);
    localparam integer V = C * VW;
    localparam integer E = C * 15;
    localparam integer I = C * 27;
    localparam integer PW = 5 * V + 2 * E + 3 * I;       // what is prepared
    localparam integer BW = XW + PW + 56 + 27;           // a buffer

    // ---- buffers --------------------------------------------------------------------------------
    wire [3*C*DW-1:0] unused_corners;
    wire [4*V-1:0]    unused_walks;
    wire [2*E-1:0]    unused_walk_rests;
    wire [V-1:0] in_start0, in_start1, in_step0, in_step1, in_base0, in_base1, in_sweep, in_side;
    wire [E-1:0] in_rest0, in_rest1;
    wire [I-1:0] in_sweep_rest, in_side_rest;
    assign {unused_corners,
            unused_walks[3*V +: V], unused_walks[2*V +: V], unused_walk_rests[E +: E],
            unused_walks[V +: V], unused_walks[0 +: V], unused_walk_rests[0 +: E],
            in_start0, in_step0, in_rest0, in_start1, in_step1, in_rest1, in_base0, in_base1,
            in_sweep, in_sweep_rest, in_side, in_side_rest} = vectors;

    wire [V-1:0] p_edge0, p_edge1, p_slant, p_next0, p_next1;
    wire [E-1:0] p_edge0_rest, p_edge1_rest;
    wire [I-1:0] p_slant_rest, p_next0_rest, p_next1_rest;

    sweep_line_prepare #(.C(C), .VW(VW), .EXACT(EXACT)) preparation (
        .moved1(prepare[5]), .moved0(prepare[4]), .down(prepare[3]), .falls(prepare[2]),
        .crosses1(prepare[1]), .crosses0(prepare[0]),
        .steps0(in_steps[27:14]), .steps1(in_steps[13:0]), .determinant(in_determinant),
        .start0(in_start0), .start1(in_start1), .step0(in_step0), .step1(in_step1),
        .rest0(in_rest0), .rest1(in_rest1), .base0(in_base0), .base1(in_base1),
        .sweep_step(in_sweep), .sweep_rest(in_sweep_rest),
        .side_step(in_side), .side_rest(in_side_rest),
        .edge0(p_edge0), .edge1(p_edge1), .edge0_rest(p_edge0_rest), .edge1_rest(p_edge1_rest),
        .slant(p_slant), .slant_rest(p_slant_rest), .next0(p_next0), .next1(p_next1),
        .next0_rest(p_next0_rest), .next1_rest(p_next1_rest)
    );

    reg  [BW-1:0] buffer0, buffer1;
    wire [BW-1:0] item = buffer ? buffer1 : buffer0;
    wire [BW-1:0] filled = {vectors, p_edge0, p_edge0_rest, p_edge1, p_edge1_rest,
                            p_slant, p_slant_rest, p_next0, p_next0_rest, p_next1, p_next1_rest,
                            in_steps, in_determinant};

    always_ff @(posedge clk) begin
        if (accept & ~fill) buffer0 <= filled;
        if (accept & fill) buffer1 <= filled;
    end

    wire [V-1:0] w0_start, w0_step, w1_start, w1_step, e0_start, e0_step, e1_start, e1_step;
    wire [V-1:0] base0, base1, sweep_step, side_step, edge0, edge1, slant, next0, next1;
    wire [E-1:0] w0_rest, w1_rest, e0_rest, e1_rest, edge0_rest, edge1_rest;
    wire [I-1:0] sweep_rest, side_rest, slant_rest, next0_rest, next1_rest;
    wire [13:0]  w0_steps, w1_steps, e0_steps, e1_steps;
    wire [26:0]  determinant;
    assign {corners, w0_start, w0_step, w0_rest, w1_start, w1_step, w1_rest,
            e0_start, e0_step, e0_rest, e1_start, e1_step, e1_rest, base0, base1,
            sweep_step, sweep_rest, side_step, side_rest,
            edge0, edge0_rest, edge1, edge1_rest, slant, slant_rest, next0, next0_rest,
            next1, next1_rest, w0_steps, w1_steps, e0_steps, e1_steps, determinant} = item;

    // ---- Vstart ---------------------------------------------------------------------------------
    reg  [V-1:0] start;
    reg  [E-1:0] start_rest;
    wire [V-1:0] start_sum;
    wire [E-1:0] start_sum_rest;
    wire [13:0]  walk_steps = walk ? w1_steps : w0_steps;
    wire [E-1:0] walk_half = (EXACT != 0) ? {C{1'b0, walk_steps}} : '0;

    sweep_line_adder #(.COMPONENTS(C), .VW(VW), .RW(15), .EXACT(EXACT)) start_adder (
        .subtract(1'b0), .modulus({1'b0, walk_steps, 1'b0}),
        .a(walk_start ? (walk ? w1_start : w0_start) : start),
        .a_rest(walk_start ? walk_half : start_rest),
        .b(walk ? w1_step : w0_step), .b_rest(walk ? w1_rest : w0_rest),
        .sum(start_sum), .sum_rest(start_sum_rest)
    );

    // ---- Vbase ----------------------------------------------------------------------------------
    // In a column's first beat: this column's, the next one's, and with the adder the one after it.
    reg  [V-1:0] base, base_after;
    reg  [I-1:0] base_rest, base_after_rest;
    wire [V-1:0] base_here = walk_start ? (walk ? base1 : base0) : base;
    wire [I-1:0] base_here_rest =
        walk_start ? ((EXACT != 0) ? {C{determinant}} : '0) : base_rest;
    wire [V-1:0] base_next = walk_start ? (walk ? next1 : next0) : base_after;
    wire [I-1:0] base_next_rest = walk_start ? (walk ? next1_rest : next0_rest) : base_after_rest;
    wire [V-1:0] base_sum;
    wire [I-1:0] base_sum_rest;
    wire [27:0]  area = {determinant, 1'b0};

    sweep_line_adder #(.COMPONENTS(C), .VW(VW), .RW(27), .EXACT(EXACT)) base_adder (
        .subtract(down), .modulus(area), .a(base_next), .a_rest(base_next_rest),
        .b(next_crosses ? slant : sweep_step), .b_rest(next_crosses ? slant_rest : sweep_rest),
        .sum(base_sum), .sum_rest(base_sum_rest)
    );

    // ---- Vedge ----------------------------------------------------------------------------------
    reg  [V-1:0] point;
    reg  [E-1:0] point_rest;
    wire [V-1:0] point_here = half_start ? (second ? edge1 : edge0) : point;
    wire [E-1:0] point_here_rest =
        half_start ? (second ? edge1_rest : edge0_rest) : point_rest;
    wire [V-1:0] point_sum;
    wire [E-1:0] point_sum_rest;

    sweep_line_adder #(.COMPONENTS(C), .VW(VW), .RW(15), .EXACT(EXACT)) edge_adder (
        .subtract(1'b0), .modulus({1'b0, second ? e1_steps : e0_steps, 1'b0}),
        .a(point_here), .a_rest(point_here_rest),
        .b(second ? e1_step : e0_step), .b_rest(second ? e1_rest : e0_rest),
        .sum(point_sum), .sum_rest(point_sum_rest)
    );

    // ---- the sides ------------------------------------------------------------------------------
    wire [V-1:0] other_start = second ? e0_start : e1_start;
    wire [V-1:0] other_step  = second ? e0_step : e1_step;
    wire [E-1:0] other_rest  = second ? e0_rest : e1_rest;
    wire [13:0]  other_steps = second ? e0_steps : e1_steps;
    wire [I-1:0] other_half  = (EXACT != 0) ? {C{13'd0, other_steps}} : '0;
    wire [27:0]  other_modulus = {13'd0, other_steps, 1'b0};
    wire [I-1:0] other_rest_27;
    genvar i;
    generate
        for (i = 0; i < C; i = i + 1) begin : g_widen
            assign other_rest_27[i*27 +: 27] = {12'd0, other_rest[i*15 +: 15]};
        end
    endgenerate

    reg  [V-1:0] left, right, kept;          // `kept`: the highest vertex in the column FIFO
    reg  [I-1:0] left_rest, right_rest, kept_rest;
    wire [V-1:0] left_here = ~first ? left : other_left ? other_start
                           : from_fifo ? kept : base_here;
    wire [I-1:0] left_here_rest = ~first ? left_rest : other_left ? other_half
                                : from_fifo ? kept_rest : base_here_rest;
    wire [V-1:0] right_here = ~first ? right : other_right ? other_start : base_next;
    wire [I-1:0] right_here_rest = ~first ? right_rest : other_right ? other_half : base_next_rest;
    wire [V-1:0] left_sum, right_sum;
    wire [I-1:0] left_sum_rest, right_sum_rest;

    sweep_line_adder #(.COMPONENTS(C), .VW(VW), .RW(27), .EXACT(EXACT)) left_adder (
        .subtract(1'b0), .modulus(other_left ? other_modulus : area),
        .a(left_here), .a_rest(left_here_rest),
        .b(other_left ? other_step : side_step), .b_rest(other_left ? other_rest_27 : side_rest),
        .sum(left_sum), .sum_rest(left_sum_rest)
    );
    sweep_line_adder #(.COMPONENTS(C), .VW(VW), .RW(27), .EXACT(EXACT)) right_adder (
        .subtract(1'b0), .modulus(other_right ? other_modulus : area),
        .a(right_here), .a_rest(right_here_rest),
        .b(other_right ? other_step : side_step), .b_rest(other_right ? other_rest_27 : side_rest),
        .sum(right_sum), .sum_rest(right_sum_rest)
    );

    always_ff @(posedge clk) begin
        if (step) begin
            left       <= left_add ? left_sum : left_here;
            left_rest  <= left_add ? left_sum_rest : left_here_rest;
            right      <= right_add ? right_sum : right_here;
            right_rest <= right_add ? right_sum_rest : right_here_rest;
            point      <= edge_step ? point_sum : point_here;
            point_rest <= edge_step ? point_sum_rest : point_here_rest;
        end
        if (step & first) begin
            start           <= start_sum;
            start_rest      <= start_sum_rest;
            base            <= base_next;
            base_rest       <= base_next_rest;
            base_after      <= base_sum;
            base_after_rest <= base_sum_rest;
        end
        if (step & keep_right) begin
            kept      <= right_sum;
            kept_rest <= right_sum_rest;
        end
    end

    assign values = {right_sum, left_sum, point_sum, point_here, start_sum};
endmodule

`default_nettype wire
