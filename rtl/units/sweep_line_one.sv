`default_nettype none

// Vertex data in one lane: the paper's register machine. Twelve registers, addressed by four bits:
//
//   0 Dprimary  1 Dedge  2 Dsweep  3 Dside  4-11 vertices  12-15 none
//
// and one adder, which makes a vertex a cycle. A vertex is assigned by copying its index. Vertices
// are Vstart, next Vbase, Vbase, Vedge, bl, br, tl, tr, each in any of the eight registers; the
// next result goes to the first that none of them is in.
//
// A beat's tasks are worked off one a cycle: at the start of a walk or half its registers are
// loaded, at that of a column Vstart and Vbase move on, then the sides and Vedge. Where a column's
// last beat needs no addition, the next column's Vstart is made meanwhile. The difference of
// another half's edge goes where nothing is needed any more: into Vbase's register in the first
// column, and into Dsweep's in the last.
module sweep_line_one #(
    parameter integer C  = 13,               // components
    parameter integer VW = 32,               // bits of a value
    parameter integer DW = 32,               // bits of data
    parameter integer EXACT = 1,
    parameter integer XW = 3*C*DW + 12*C*VW + 114*C  // bits of an item's vectors
) (
    input  wire            clk,
    input  wire            rst_n,
    input  wire            accept,           // an item comes
    input  wire            fill,             // to this buffer
    input  wire [XW-1:0]   vectors,
    input  wire [55:0]     in_steps,         // of walks 0, 1 and edges 0, 1, the last in low bits
    input  wire [26:0]     in_determinant,

    input  wire            valid,            // a beat is here,
    input  wire            step,             //   and leaves
    output wire            done,             // it may
    input  wire            buffer,           // its item
    input  wire            second, walk,     // its half and walk
    input  wire            first,            // it starts a column,
    input  wire            half_start,       // a half,
    input  wire            walk_start,       // a walk
    input  wire            column_end,
    input  wire            column_ahead,     // the walk goes on in this half
    input  wire            down,             // direction of the sweep
    input  wire            crosses, falls,   // Vstart crosses a row, downwards
    input  wire            edge_moved,       // the half's first edge point is not the edge's start
    input  wire            edge_step,
    input  wire [1:0]      left,             // onto what the sides step: 0 they stay, 1 inside,
    input  wire [1:0]      right,            //   2 the edge, 3 the other half's edge
    input  wire            other_left, other_right, // the column is the other half's edge
    output wire [3*C*DW-1:0] corners,        // corner 0 in the high bits
    output wire [5*C*VW-1:0] values          // tr, tl, edge one step on, edge, start
);
    localparam integer V  = C * VW;
    localparam integer E  = C * 15;
    localparam integer I  = C * 27;
    localparam integer RW = I + V;                       // a register: remainders, values
    localparam integer BW = XW + 56 + 27;                // a buffer
    localparam [3:0] NONE = 4'd15;
    localparam [1:0] STAY = 2'd0, ON_EDGE = 2'd2;

    // ---- buffers --------------------------------------------------------------------------------
    reg  [BW-1:0] buffer0, buffer1;
    wire [BW-1:0] item = buffer ? buffer1 : buffer0;
    always_ff @(posedge clk) begin
        if (accept & ~fill) buffer0 <= {vectors, in_steps, in_determinant};
        if (accept & fill) buffer1 <= {vectors, in_steps, in_determinant};
    end

    wire [V-1:0] w0_start, w0_step, w1_start, w1_step, e0_start, e0_step, e1_start, e1_step;
    wire [V-1:0] base0, base1, sweep_step, side_step;
    wire [E-1:0] w0_rest, w1_rest, e0_rest, e1_rest;
    wire [I-1:0] sweep_rest, side_rest;
    wire [13:0]  w0_steps, w1_steps, e0_steps, e1_steps;
    wire [26:0]  determinant;
    assign {corners, w0_start, w0_step, w0_rest, w1_start, w1_step, w1_rest,
            e0_start, e0_step, e0_rest, e1_start, e1_step, e1_rest, base0, base1,
            sweep_step, sweep_rest, side_step, side_rest,
            w0_steps, w1_steps, e0_steps, e1_steps, determinant} = item;

    wire [13:0] walk_steps  = walk ? w1_steps : w0_steps;
    wire [13:0] edge_steps  = second ? e1_steps : e0_steps;
    wire [13:0] other_steps = second ? e0_steps : e1_steps;

    // ---- tasks, in their order ------------------------------------------------------------------
    localparam integer T = 16;
    localparam integer LOAD_SWEEP = 0, LOAD_SIDE = 1, LOAD_PRIMARY = 2, LOAD_START = 3,
                       LOAD_BASE = 4, LOAD_EDGE_STEP = 5, LOAD_EDGE = 6, EDGE_FIRST = 7,
                       START = 8, BASE = 9, BASE_SIDE = 10, LOAD_OTHER = 11, LOAD_OTHER_STEP = 12,
                       LEFT = 13, EDGE = 14, RIGHT = 15;

    reg          begun;                      // this beat's first cycle is over
    reg  [T-1:0] rest_of_tasks;
    reg          ahead_valid;                // the next column's Vstart is there
    wire [T-1:0] wanted = {
        right[0], edge_step, left[0],
        first & (other_left | other_right), first & (other_left | other_right),
        first & crosses, first, first & ~ahead_valid,
        half_start & edge_moved, half_start, half_start, {5{walk_start}}};
    wire [T-1:0] tasks = begun ? rest_of_tasks : wanted;
    wire [T-1:0] task_now = tasks & (~tasks + 1'b1);     // the first
    wire         idle  = tasks == '0;
    // A beat without additions leaves the adder to the next column.
    wire         ahead = valid & idle & ~begun & column_end & column_ahead;
    assign done = (tasks & ~task_now) == '0;

    // ---- registers ------------------------------------------------------------------------------
    reg [RW-1:0] file [0:11];
    reg [3:0] r_start, r_next, r_base, r_edge, r_old, r_bl, r_br, r_tl, r_tr, r_ahead;
    reg       left_moved, right_moved;

    // A column begins with a Vstart that was made ahead.
    wire       shift   = ~begun & first & ahead_valid;
    wire [3:0] i_start = shift ? r_ahead : r_start;
    wire [3:0] i_bl    = shift ? r_start : r_bl;
    wire [3:0] i_br    = shift ? r_ahead : r_br;
    wire [3:0] i_old   = begun ? r_old : r_edge;         // Vedge as the beat found it

    wire [15:0] used = (16'd1 << i_start) | (16'd1 << r_next) | (16'd1 << r_base)
                     | (16'd1 << r_edge) | (16'd1 << i_old) | (16'd1 << i_bl) | (16'd1 << i_br)
                     | (16'd1 << r_tl) | (16'd1 << r_tr)
                     | (16'd1 << (ahead_valid ? r_ahead : NONE));
    wire unused_codes = &{1'b0, used[15:11], used[3:0]};
    wire [3:0] free = ~used[4] ? 4'd4 : ~used[5] ? 4'd5 : ~used[6] ? 4'd6 : ~used[7] ? 4'd7
                    : ~used[8] ? 4'd8 : ~used[9] ? 4'd9 : ~used[10] ? 4'd10 : 4'd11;

    // ---- the adder ------------------------------------------------------------------------------
    wire left_other  = task_now[LEFT] & other_left;
    wire right_other = task_now[RIGHT] & other_right;
    wire on_edge_add = task_now[EDGE] | task_now[EDGE_FIRST];
    wire on_primary  = task_now[START] | ahead;
    wire [3:0] operand = on_primary ? i_start : task_now[BASE] ? r_base
                       : task_now[BASE_SIDE] ? r_next : on_edge_add ? r_edge
                       : task_now[LEFT] ? (other_left | left_moved & ~first ? i_bl : r_base)
                       : (other_right | right_moved & ~first) ? i_br : r_next;
    wire [3:0] difference = on_primary ? 4'd0 : on_edge_add ? 4'd1
                          : task_now[BASE] | right_other ? 4'd2 : left_other ? r_base : 4'd3;
    wire [27:0] modulus = on_primary ? {13'd0, walk_steps, 1'b0}
                        : on_edge_add ? {13'd0, edge_steps, 1'b0}
                        : left_other | right_other ? {13'd0, other_steps, 1'b0}
                        : {determinant, 1'b0};
    wire [RW-1:0] a = file[operand < 4'd12 ? operand : 4'd0];
    wire [RW-1:0] b = file[difference < 4'd12 ? difference : 4'd0];
    wire [RW-1:0] sum;

    sweep_line_adder #(.COMPONENTS(C), .VW(VW), .RW(27), .EXACT(EXACT)) adder (
        .subtract((task_now[BASE] & down) | (task_now[BASE_SIDE] & falls)), .modulus(modulus),
        .a(a[0 +: V]), .a_rest(a[V +: I]), .b(b[0 +: V]), .b_rest(b[V +: I]),
        .sum(sum[0 +: V]), .sum_rest(sum[V +: I])
    );

    // ---- loading --------------------------------------------------------------------------------
    // Exact accumulators start with half a modulus as remainder.
    function automatic [I-1:0] widened(input [E-1:0] rests);
        integer i;
        for (i = 0; i < C; i = i + 1) widened[i*27 +: 27] = {12'd0, rests[i*15 +: 15]};
    endfunction
    function automatic [I-1:0] half_of(input [26:0] divisor);
        half_of = (EXACT != 0) ? {C{divisor}} : '0;
    endfunction

    wire [RW-1:0] loaded =
          task_now[LOAD_SWEEP]   ? {sweep_rest, sweep_step}
        : task_now[LOAD_SIDE]    ? {side_rest, side_step}
        : task_now[LOAD_PRIMARY] ? {widened(walk ? w1_rest : w0_rest), walk ? w1_step : w0_step}
        : task_now[LOAD_START]   ? {half_of({13'd0, walk_steps}), walk ? w1_start : w0_start}
        : task_now[LOAD_BASE]    ? {half_of(determinant), walk ? base1 : base0}
        : task_now[LOAD_EDGE_STEP] ? {widened(second ? e1_rest : e0_rest),
                                      second ? e1_step : e0_step}
        : task_now[LOAD_EDGE]    ? {half_of({13'd0, edge_steps}), second ? e1_start : e0_start}
        : task_now[LOAD_OTHER]   ? {half_of({13'd0, other_steps}), second ? e0_start : e1_start}
        : {widened(second ? e0_rest : e1_rest), second ? e0_step : e1_step};
    wire loads = |task_now[LOAD_EDGE:LOAD_SWEEP] | task_now[LOAD_OTHER] | task_now[LOAD_OTHER_STEP];
    wire [3:0] target = task_now[LOAD_SWEEP] ? 4'd2 : task_now[LOAD_SIDE] ? 4'd3
                      : task_now[LOAD_PRIMARY] ? 4'd0 : task_now[LOAD_EDGE_STEP] ? 4'd1
                      : task_now[LOAD_OTHER] ? (other_left ? i_bl : i_br)
                      : task_now[LOAD_OTHER_STEP] ? (other_left ? r_base : 4'd2) : free;
    wire          write   = valid & (~idle | ahead);
    wire [RW-1:0] written = loads ? loaded : sum;

    always_ff @(posedge clk) begin
        if (write) file[target] <= written;
    end

    // ---- indices --------------------------------------------------------------------------------
    wire [3:0] n_start = task_now[START] | task_now[LOAD_START] ? free : i_start;
    wire [3:0] n_bl    = task_now[START] ? i_start : i_bl;
    wire [3:0] n_br    = task_now[START] ? free : i_br;
    wire [3:0] n_next  = task_now[BASE] | task_now[BASE_SIDE] ? free : r_next;
    wire [3:0] n_base  = task_now[LOAD_BASE] ? free : r_base;
    wire [3:0] n_edge  = task_now[LOAD_EDGE] | on_edge_add ? free : r_edge;
    wire [3:0] n_tl    = task_now[LEFT] ? free : r_tl;
    wire [3:0] n_tr    = task_now[RIGHT] ? free : r_tr;
    // Until the half has its first edge point, no older one is to be kept.
    wire [3:0] n_old   = half_start & |task_now[EDGE_FIRST:LOAD_SWEEP] ? n_edge : i_old;

    always_ff @(posedge clk) begin
        if (!rst_n) begin
            begun       <= 1'b0;
            ahead_valid <= 1'b0;
        end else if (valid) begin
            begun <= ~step;
            if (ahead) ahead_valid <= 1'b1;
            else if (first | walk_start) ahead_valid <= 1'b0;
        end
    end

    always_ff @(posedge clk) begin
        if (valid) begin
            rest_of_tasks <= tasks & ~task_now;
            r_start <= n_start;
            r_next  <= n_next;
            r_base  <= n_base;
            r_edge  <= n_edge;
            r_old   <= n_old;
            r_bl    <= n_bl;
            r_br    <= n_br;
            r_tl    <= n_tl;
            r_tr    <= n_tr;
            if (ahead) r_ahead <= free;
            if (task_now[LOAD_SWEEP])
                {r_start, r_next, r_base, r_edge, r_old, r_bl, r_br, r_tl, r_tr} <= {9{NONE}};
            if (step) begin
                left_moved  <= left != STAY | (left_moved & ~first);
                right_moved <= right != STAY | (right_moved & ~first);
                r_bl <= column_end ? NONE : left == ON_EDGE ? n_old : left != STAY ? n_tl : n_bl;
                r_br <= column_end ? NONE : right == ON_EDGE ? n_edge
                      : right != STAY ? n_tr : n_br;
                r_tl <= NONE;
                r_tr <= NONE;
                if (column_end) begin
                    r_base <= n_next;
                    r_next <= NONE;
                end
            end
        end
    end

    // What this cycle makes is sent in it.
    wire [5*4-1:0] sent = {n_tr, n_tl, n_edge, n_old, n_start};
    genvar k;
    generate
        for (k = 0; k < 5; k = k + 1) begin : g_sent
            wire [3:0]    index = sent[4*k +: 4];
            wire [RW-1:0] stored = file[index < 4'd12 ? index : 4'd0];
            assign values[k*V +: V] = write & ~loads & index == free ? sum[0 +: V]
                                                                     : stored[0 +: V];
            wire unused_rest = &{1'b0, stored[V +: I]};
        end
    endgenerate
endmodule

`default_nettype wire
