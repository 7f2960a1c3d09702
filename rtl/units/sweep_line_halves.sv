`default_nettype none

// Takes base triangles apart into halves, those without width left out, and has the next one ready
// for the side walk: its description, and the slots that it starts with.
//
// Items stand in two buffers, used by turns. `waiting` says which of them has halves left to hand
// on, `done` that this one has no more. A half is handed on in every cycle if need be.
module sweep_line_halves #(
    parameter integer SW  = 309,          // bits of an item's scalars
    parameter integer HW  = 217,          // bits of a half's description
    parameter integer ROW = 15
) (
    input  wire             clk,
    input  wire             rst_n,
    input  wire [1:0]       waiting,
    output wire [1:0]       done,
    input  wire [2*SW-1:0]  items,       // buffer 0 in the low bits

    output reg              out_valid,
    input  wire             out_ready,
    output reg  [HW-1:0]    half,
    output reg  [4*ROW+45:0] initial_slots
);
    reg buffer, second;                  // what comes next

    wire        single, continues, mirrored;
    wire [13:0] sweep_start;
    wire [26:0] unused_determinant;
    wire [16:0] limit;
    wire [19:0] half0, half1;
    wire [51:0] walk0, walk1, edge0, edge1;
    assign {single, continues, mirrored, sweep_start, unused_determinant, limit, half0, half1,
            walk0, walk1, edge0, edge1} = buffer ? items[SW +: SW] : items[0 +: SW];

    // Columns stand in a half's high bits.
    wire empty0 = half0[19 -: 14] == '0;
    wire empty1 = half1[19 -: 14] == '0;
    wire is_second = second | (~single & empty0);
    wire is_final  = single | is_second | empty1;
    wire is_item   = ~second;
    wire is_fresh  = is_item | ~continues;
    wire is_walk1  = is_second & ~continues;

    wire [19:0] this_half  = is_second ? half1 : half0;
    wire [51:0] this_walk  = is_walk1 ? walk1 : walk0;
    wire [51:0] this_edge  = is_second ? edge1 : edge0;
    wire [51:0] other_edge = is_second ? edge0 : edge1;

    // Of a walk: edge, from, to, backward, steps, row, quotient, rest.
    wire [13:0] walk_steps = this_walk[44 -: 14];
    wire [13:0] walk_row   = this_walk[30 -: 14];
    wire [13:0] edge_steps = this_edge[44 -: 14];
    wire [13:0] edge_row   = this_edge[30 -: 14];
    // A roof's second half comes from the primary edge's other end.
    wire [13:0] sweep = is_walk1 ? sweep_start + walk0[44 -: 14] : sweep_start;

    // Vstart, and where it is a column later.
    wire [ROW+14:0] start_0 = {{(ROW - 14){walk_row[13]}}, walk_row, 1'b0, walk_steps};
    wire [ROW+14:0] start_1;
    sweep_line_slot #(.ROW(ROW)) start_on (
        .slot(start_0), .quotient(this_walk[16:15]), .rest(this_walk[14:0]), .steps(walk_steps),
        .moved(start_1)
    );

    // Vedge: at a tip, its first point is Vstart; beside a half without width, the other edge's.
    wire [13:0] columns = this_half[19 -: 14];
    wire        moved = this_half[3] | this_half[1];
    wire        column_quotient = columns == edge_steps;
    wire [14:0] column_rest = column_quotient ? '0 : {columns, 1'b0};
    wire [ROW+14:0] row_0 = {{(ROW - 14){edge_row[13]}}, edge_row, 1'b0, edge_steps};
    wire [ROW+14:0] column_0 = {{ROW{1'b0}}, 1'b0, edge_steps};
    wire [ROW+14:0] row_1, column_1;
    sweep_line_slot #(.ROW(ROW)) row_on (
        .slot(row_0), .quotient(this_edge[16:15]), .rest(this_edge[14:0]), .steps(edge_steps),
        .moved(row_1)
    );
    sweep_line_slot #(.ROW(ROW)) column_on (
        .slot(column_0), .quotient({1'b0, column_quotient}), .rest(column_rest),
        .steps(edge_steps), .moved(column_1)
    );

    wire valid = buffer ? waiting[1] : waiting[0];
    wire load  = valid & (~out_valid | out_ready);
    assign done = {load & is_final & buffer, load & is_final & ~buffer};

    always_ff @(posedge clk) begin
        if (!rst_n) begin
            out_valid <= 1'b0;
            buffer    <= 1'b0;
            second    <= 1'b0;
        end else begin
            out_valid <= valid | (out_valid & ~out_ready);
            if (load) begin
                buffer <= buffer ^ is_final;
                second <= ~is_final;
            end
        end
    end

    always_ff @(posedge clk) begin
        if (load) begin
            half <= {buffer, is_second, is_walk1, single, is_item, is_fresh, is_final,
                     ~is_second & ~empty1, continues, mirrored, limit, sweep,
                     this_half, this_walk, this_edge, other_edge};
            initial_slots <= {moved, moved ? row_1 : row_0, moved ? column_1 : column_0,
                              start_0[ROW+14:15], start_1};
        end
    end
endmodule

`default_nettype wire
