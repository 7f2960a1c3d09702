`default_nettype none

// The Summed Height Test (Doggett and Hirche 2000, sections 2.3 and 3.1.3): sht = 1 if the height
// around the new vertex U12 differs from the height around the two ends by more than a threshold.
//
//     average:  |S12 (A1 + A2) - (S1 + S2) A12| > threshold A12 (A1 + A2)
//     sum:      |S12 - 2 (S1 + S2)| > 2 threshold
//
// with S and A the sum of heights in a box and its area. Both sides of an edge get the same
// answer: half-extents come from |u1 - u2|, and the two ends are added before anything else.
//
// A sum is four entries of a table of exclusive prefix sums (equation 2),
//
//     S = T(hi, hi) - T(lo, hi) - T(hi, lo) + T(lo, lo),
//
// the products of the columns (+hi, -lo) and the rows (+hi, -lo). A box that crosses a seam of a
// periodic map has a third column +W or a third row +H: 6 or 9 entries. Arithmetic is modulo
// 2^SAT_WIDTH, exact because the sums themselves are smaller.
//
// Stage 1: half-extents. Stages 2, 3: corners, brought into the map. Stage 4: areas; the item stays
// while its entries are read, those of the three boxes side by side, one of each a cycle. Answers
// are summed as they come. Stages 5 to 8: sums, products, differences, comparison.
//
// An item must be one for which the sums are exact: no edge longer than 4096 texels, no box sum of
// 2^SAT_WIDTH or more, on a periodic map no corner more than one period outside. That is the
// base mesh's business and checked there.
//
// Time, with memory latency 1 and no seam crossed: latency 13, one item in 4 cycles, 10 items
// inside. A skipped item reads nothing and takes one cycle.
module height_test #(
`include "rtl/units/height_test_params.svh"
) (
    input  wire                       clk,
    input  wire                       rst_n,         // synchronous, low

    // Registers, stable while items are in the unit.
    input  wire [12:0]                map_width,     // W, texels, 1..4096
    input  wire [12:0]                map_height,    // H
    input  wire                       wrap,          // the map is periodic; otherwise clamped
    input  wire                       literal,       // boxes of |du| by |dv|; otherwise square
    input  wire                       sum,           // compare sums; otherwise averages
    input  wire [SAT_WIDTH-1:0]       threshold,     // averages: height LSB, HEIGHT_WIDTH bits
                                                     // sums: height LSB * texel^2

    input  wire                       in_valid,
    output wire                       in_ready,
    input  wire                       skip,          // the edge is decided: pass with sht = 0
    input  wire signed [UV_WIDTH-1:0] u1_x,          // end 1, in texels
    input  wire signed [UV_WIDTH-1:0] u1_y,
    input  wire signed [UV_WIDTH-1:0] u2_x,          // end 2
    input  wire signed [UV_WIDTH-1:0] u2_y,
    input  wire signed [UV_WIDTH-1:0] u12_x,         // the vertex that would split the edge
    input  wire signed [UV_WIDTH-1:0] u12_y,

    // The read port of the summed-area table: up to three entries at once, for the boxes around U1
    // (low bits), U2 and U12, by their coordinates 0..W and 0..H. Answers in order, never refused;
    // those of entries that were not asked for are ignored.
    output wire                       sat_valid,
    input  wire                       sat_ready,
    output wire [2:0]                 sat_read,      // which of the three are wanted
    output wire [3*13-1:0]            sat_x,
    output wire [3*13-1:0]            sat_y,
    input  wire                       sat_rvalid,
    output wire                       sat_rready,
    input  wire [3*SAT_WIDTH-1:0]     sat_rdata,

    output wire                       out_valid,
    input  wire                       out_ready,
    output wire                       sht            // the heights differ
);
    localparam integer HW = UV_WIDTH - 2;  // a half-extent: at most a quarter of a difference
    localparam integer SW = SAT_WIDTH;
    localparam integer AW = 23;            // an area: at most 2048 * 2048 texels

    // Beats in flight: one a cycle while the memory answers within 6 cycles.
    localparam integer IN_FLIGHT = 8;

    // |a - b| of two signed W-bit numbers: W bits, unsigned.
    function automatic [UV_WIDTH-1:0] absolute_difference(
        input signed [UV_WIDTH-1:0] a,
        input signed [UV_WIDTH-1:0] b
    );
        absolute_difference = (a < b) ? b - a : a - b;
    endfunction

    // The extent that sizes the boxes along one axis.
    function automatic [UV_WIDTH-1:0] extent(
        input [UV_WIDTH-1:0] along,
        input [UV_WIDTH-1:0] across,
        input                square
    );
        extent = (square && across > along) ? across : along;
    endfunction

    // Stage 1: half-extents, e >> 2 around U12 and e >> 3 around the ends.
    wire [2:0] load;                       // register enables of stages 1 to 3
    wire       sized_valid;
    wire       sized_ready;
    wire       sized_skip;

    rp_pipe #(.W(1), .L(3)) sizing (
        .clk      (clk),
        .rst_n    (rst_n),
        .in_valid (in_valid),
        .in_ready (in_ready),
        .in_data  (skip),
        .out_valid(sized_valid),
        .out_ready(sized_ready),
        .out_data (sized_skip),
        .load     (load)
    );

    reg [HW-1:0] half_x, half_y;           // around U12; half as much around the ends

    always_ff @(posedge clk) begin
        if (load[0]) begin
            half_x <= HW'(extent(absolute_difference(u1_x, u2_x),
                                 absolute_difference(u1_y, u2_y), ~literal) >> 2);
            half_y <= HW'(extent(absolute_difference(u1_y, u2_y),
                                 absolute_difference(u1_x, u2_x), ~literal) >> 2);
        end
    end

    // The three boxes are numbered 0: U1, 1: U2, 2: U12.
    wire signed [UV_WIDTH-1:0] u_x [0:2];
    wire signed [UV_WIDTH-1:0] u_y [0:2];

    assign u_x[0] = u1_x;
    assign u_y[0] = u1_y;
    assign u_x[1] = u2_x;
    assign u_y[1] = u2_y;
    assign u_x[2] = u12_x;
    assign u_y[2] = u12_y;

    wire          load_item;               // register enable of stage 4
    wire [2:0]    x_seam, y_seam;          // which boxes cross a seam
    wire [AW-1:0] area [0:2];
    wire [1:0]    column, row;             // what is being read
    wire [2:0]    wanted;                  // boxes whose sums need it

    genvar b;
    generate
        for (b = 0; b < 3; b = b + 1) begin : g_box
            height_test_box #(.UV_WIDTH(UV_WIDTH), .UV_FRAC(UV_FRAC), .AW(AW)) box (
                .clk       (clk),
                .load      (load),
                .load_item (load_item),
                .map_width (map_width),
                .map_height(map_height),
                .wrap      (wrap),
                .sum       (sum),
                .u_x       (u_x[b]),
                .u_y       (u_y[b]),
                .half_x    ((b == 2) ? half_x : half_x >> 1),
                .half_y    ((b == 2) ? half_y : half_y >> 1),
                .x_seam    (x_seam[b]),
                .y_seam    (y_seam[b]),
                .area      (area[b]),
                .column    (column),
                .row       (row),
                .wanted    (wanted[b]),
                .entry_x   (sat_x[b*13 +: 13]),
                .entry_y   (sat_y[b*13 +: 13])
            );
        end
    endgenerate

    // Stage 4: one beat for each pair of a column and a row, a third one if some box crosses a
    // seam. A skipped item is one beat that reads nothing.
    wire [3:0] beats = sized_skip ? 4'd1
                     : (|x_seam & |y_seam) ? 4'd9
                     : (|x_seam | |y_seam) ? 4'd6
                     : 4'd4;

    wire       beat_valid, beat_ready;
    wire       beat_skip, beat_last;
    wire [3:0] beat_j;

    rp_expand #(.W(1), .NW(4)) reading (
        .clk      (clk),
        .rst_n    (rst_n),
        .in_valid (sized_valid),
        .in_ready (sized_ready),
        .in_data  (sized_skip),
        .in_n     (beats),
        .out_valid(beat_valid),
        .out_ready(beat_ready),
        .out_data (beat_skip),
        .out_j    (beat_j),
        .out_last (beat_last),
        .load     (load_item)
    );

    reg          three_columns;            // some box has a third column
    reg [AW-1:0] mid_area;
    reg [AW:0]   ends_area;                // both ends together

    always_ff @(posedge clk) begin
        if (load_item) begin
            three_columns <= |x_seam;
            mid_area      <= area[2];
            ends_area     <= {1'b0, area[0]} + {1'b0, area[1]};
        end
    end

    // Beat j is for row j / columns and column j mod columns. Row and column number 1 are the low
    // ones, subtracted; an entry for both is added again.
    assign row    = ~three_columns ? beat_j[2:1]
                  : (beat_j >= 4'd6) ? 2'd2
                  : (beat_j >= 4'd3) ? 2'd1
                  : 2'd0;
    assign column = three_columns ? 2'(beat_j - 4'd3 * {2'b00, row}) : {1'b0, beat_j[0]};

    wire minus = (column == 2'd1) ^ (row == 2'd1);

    // The reads, and their answers in order. The areas ride along with each beat: 47 bits in 8
    // places cost less than another queue with a fork before and a join behind it.
    wire            answer_valid, answer_ready;
    wire            answer_first, answer_last, answer_minus;
    wire [2:0]      answer_wanted;
    wire            answer_read;
    wire [AW-1:0]   answer_mid_area;
    wire [AW:0]     answer_ends_area;
    wire [3*SW-1:0] answer;

    rp_client #(.DW(3 * SW), .TW(6 + 2 * AW + 1), .K(IN_FLIGHT)) reader (
        .clk       (clk),
        .rst_n     (rst_n),
        .in_valid  (beat_valid),
        .in_ready  (beat_ready),
        .in_read   (~beat_skip),
        .in_tag    ({beat_j == 4'd0, beat_last, minus, wanted, mid_area, ends_area}),
        .mem_valid (sat_valid),
        .mem_ready (sat_ready),
        .mem_rvalid(sat_rvalid),
        .mem_rready(sat_rready),
        .mem_rdata (sat_rdata),
        .out_valid (answer_valid),
        .out_ready (answer_ready),
        .out_tag   ({answer_first, answer_last, answer_minus, answer_wanted,
                     answer_mid_area, answer_ends_area}),
        .out_read  (answer_read),
        .out_data  (answer)
    );

    assign sat_read = wanted;

    // Stages 5 to 8.
    height_test_decision #(
        .SAT_WIDTH(SAT_WIDTH), .HEIGHT_WIDTH(HEIGHT_WIDTH), .AW(AW)
    ) decision (
        .clk      (clk),
        .rst_n    (rst_n),
        .sum      (sum),
        .threshold(threshold),
        .in_valid (answer_valid),
        .in_ready (answer_ready),
        .skip     (~answer_read),
        .first    (answer_first),
        .last     (answer_last),
        .minus    (answer_minus),
        .wanted   (answer_wanted),
        .entries  (answer),
        .mid_area (answer_mid_area),
        .ends_area(answer_ends_area),
        .out_valid(out_valid),
        .out_ready(out_ready),
        .sht      (sht)
    );
endmodule

`default_nettype wire
