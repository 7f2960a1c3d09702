`default_nettype none

// One way of the cache: for each set a line's tag and its words. Read in the same cycle.
module texel_cache_way #(
    parameter integer SETS  = 1,
    parameter integer SW    = 1,  // bits of a set's number
    parameter integer WORDS = 1,  // of a line
    parameter integer LW    = 1,  // bits of a word's number in its line
    parameter integer TW    = 1,  // bits of a tag
    parameter integer DW    = 1   // bits of a word
) (
    input  wire          clk,
    input  wire          rst_n,       // synchronous, low: no lines
    input  wire          invalidate,  // drop all lines
    input  wire [SW-1:0] set,
    input  wire [LW-1:0] word,
    input  wire [TW-1:0] tag,
    output wire          there,       // the set has a line in this way
    output wire          match,       // it is the line with this tag
    output wire [DW-1:0] data,
    input  wire          fill,        // a word of a new line comes
    input  wire          fill_last,   // and with it the line is complete
    input  wire [LW-1:0] fill_word,
    input  wire [DW-1:0] fill_data
);
    localparam integer PW = (SETS * WORDS > 1) ? $clog2(SETS * WORDS) : 1;  // a word's place

    reg [SETS-1:0] valid;
    reg [TW-1:0]   tags  [0:SETS-1];
    reg [DW-1:0]   words [0:SETS*WORDS-1];

    assign there = valid[set];
    assign match = there & (tags[set] == tag);
    assign data  = words[PW'(set) * PW'(WORDS) + PW'(word)];

    // While a line comes in, the set's old one stands, with some words overwritten: nobody asks
    // for it before the new tag is written, since the cache waits for the line.
    always_ff @(posedge clk) begin
        if (!rst_n | invalidate) valid <= '0;
        else if (fill_last) valid[set] <= 1'b1;
    end

    always_ff @(posedge clk) begin
        if (fill_last) tags[set] <= tag;
        if (fill) words[PW'(set) * PW'(WORDS) + PW'(fill_word)] <= fill_data;
    end
endmodule

`default_nettype wire
