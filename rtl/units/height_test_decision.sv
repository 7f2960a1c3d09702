`default_nettype none

// The decision of the Summed Height Test: sums the entries of each box as they are read, and
// compares the box around U12 with those around both ends together.
//
//     average:  |S12 A - S A12| > threshold A12 A       S = S1 + S2, A = A1 + A2
//     sum:      |S12 - 2 S| > 2 threshold
//
// Stage 1: sums, modulo 2^SAT_WIDTH. Stages 2 to 4: products, differences, comparison.
//
// Time: a beat is taken in each cycle; latency 4 from an item's last beat.
module height_test_decision #(
    parameter integer SAT_WIDTH    = 38,  // bits of a table entry, and of a sum
    parameter integer HEIGHT_WIDTH = 16,  // bits of a height, and of a threshold on averages
    parameter integer AW           = 23   // bits of an area
) (
    input  wire                   clk,
    input  wire                   rst_n,       // synchronous, low

    // Registers of the unit.
    input  wire                   sum,         // compare sums; otherwise averages
    input  wire [SAT_WIDTH-1:0]   threshold,

    // Beats: up to one entry for each box.
    input  wire                   in_valid,
    output wire                   in_ready,
    input  wire                   skip,        // the item was skipped: this is its only beat
    input  wire                   first,       // of the item
    input  wire                   last,
    input  wire                   minus,       // the entries are subtracted
    input  wire [2:0]             wanted,      // boxes that have an entry; 0: U1, 1: U2, 2: U12
    input  wire [3*SAT_WIDTH-1:0] entries,
    input  wire [AW-1:0]          mid_area,    // of the box around U12
    input  wire [AW:0]            ends_area,   // of both others together

    output wire                   out_valid,
    input  wire                   out_ready,
    output wire                   sht
);
    localparam integer SW = SAT_WIDTH;
    localparam integer GW = 2 * AW + 1;     // the product of one area and two together
    localparam integer PW = 63;             // SW + AW + 1 <= 63, HEIGHT_WIDTH + GW <= 63

    wire       item_valid;
    wire       item_ready;
    wire       load_beat;
    wire       skipped;
    wire [3:0] load;

    rp_collect collecting (
        .in_valid (in_valid),
        .in_ready (in_ready),
        .in_last  (last),
        .out_valid(item_valid),
        .out_ready(item_ready),
        .load     (load_beat)
    );

    rp_pipe #(.W(1), .L(4)) stages (
        .clk      (clk),
        .rst_n    (rst_n),
        .in_valid (item_valid),
        .in_ready (item_ready),
        .in_data  (skip),
        .out_valid(out_valid),
        .out_ready(out_ready),
        .out_data (skipped),
        .load     (load)
    );

    wire unused_load = load[0];             // stage 1 takes every beat, not only the last

    // Stage 1: sums. The two ends are added to each other from the start: together they stay
    // below half of 2^SAT_WIDTH.
    function automatic [SW-1:0] term(
        input [SW-1:0] entry,
        input          present,
        input          negative
    );
        term = ~present ? '0 : negative ? -entry : entry;
    endfunction

    reg [SW-1:0] mid_sum;
    reg [SW-1:0] ends_sum;
    reg [AW-1:0] mid_texels;                // the areas
    reg [AW:0]   ends_texels;

    always_ff @(posedge clk) begin
        if (load_beat) begin
            mid_sum     <= (first ? '0 : mid_sum) + term(entries[2*SW +: SW], wanted[2], minus);
            ends_sum    <= (first ? '0 : ends_sum) + term(entries[0 +: SW], wanted[0], minus)
                         + term(entries[SW +: SW], wanted[1], minus);
            mid_texels  <= mid_area;
            ends_texels <= ends_area;
        end
    end

    // Stage 2: products, the two sides to compare, and the area that multiplies the threshold.
    reg [PW-1:0] mid_side;
    reg [PW-1:0] ends_side;
    reg [GW-1:0] areas;

    always_ff @(posedge clk) begin
        if (load[1]) begin
            mid_side  <= sum ? PW'(mid_sum) : PW'(mid_sum) * PW'(ends_texels);
            ends_side <= sum ? PW'({ends_sum, 1'b0}) : PW'(ends_sum) * PW'(mid_texels);
            areas     <= GW'(mid_texels) * GW'(ends_texels);
        end
    end

    // Stage 3: differences. That of two sums lies within +-2^SW: one bit more than the table
    // stores holds it with its sign, and it is taken modulo that.
    function automatic [PW-1:0] sum_difference(
        input [SW:0] a,
        input [SW:0] b
    );
        reg [SW:0] d;
        begin
            d = a - b;
            if (d[SW]) d = -d;
            sum_difference = PW'(d);
        end
    endfunction

    function automatic [PW-1:0] difference(
        input [PW-1:0] a,
        input [PW-1:0] b
    );
        difference = (a < b) ? b - a : a - b;
    endfunction

    reg [PW-1:0] magnitude;
    reg [PW-1:0] limit;

    always_ff @(posedge clk) begin
        if (load[2]) begin
            magnitude <= sum ? sum_difference(mid_side[SW:0], ends_side[SW:0])
                             : difference(mid_side, ends_side);
            limit     <= sum ? PW'({threshold, 1'b0})
                             : PW'(threshold[HEIGHT_WIDTH-1:0]) * PW'(areas);
        end
    end

    // Stage 4: comparison.
    reg differs;

    always_ff @(posedge clk) begin
        if (load[3]) differs <= magnitude > limit;
    end

    assign sht = differs & ~skipped;
endmodule

`default_nettype wire
