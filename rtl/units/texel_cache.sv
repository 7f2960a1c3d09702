`default_nettype none

// The cache at the read port of a map-reading unit: blocking, in order. 2^CACHE_SET_BITS sets of
// CACHE_WAYS lines of 2^CACHE_LINE_BITS words; HEIGHT_WIDTH is the width of the reader's words.
//
// A read stands in one register while it is looked up. If its line is there it leaves in the next
// cycle. Otherwise the words of the line are fetched in turn, one request a cycle, into the way
// that the set's order names; the read leaves in the cycle after the last word is in.
//
// Time: hit: offer = A(i) + 1. Miss: requests a(j) >= max(A(i) + 1, a(j-1) + 1), each answered at
// d(j) by the client; offer = d(last) + 1. D(i) = max(offer, R), A(i) = max(V, D(i-1)).
module texel_cache #(
`include "rtl/units/texel_cache_params.svh"
) (
    input  wire                    clk,
    input  wire                    rst_n,         // synchronous, low

    input  wire                    in_valid,
    output wire                    in_ready,
    input  wire                    invalidate,    // drop all lines before this read
    input  wire [29:0]             address,       // number of the word in its table

    // The memory: requests for words, and answers in their order.
    output wire                    word_valid,
    input  wire                    word_ready,
    output wire [29:0]             word_address,
    input  wire                    word_rvalid,
    output wire                    word_rready,
    input  wire [HEIGHT_WIDTH-1:0] word_rdata,

    output wire                    out_valid,
    input  wire                    out_ready,
    output wire [HEIGHT_WIDTH-1:0] data,
    output wire                    hit,           // the line was there
    output wire [2:0]              way,           // where it is
    output wire                    evicted        // another line made way for it
);
    localparam integer AW    = 30;
    localparam integer DW    = HEIGHT_WIDTH;
    localparam integer SETS  = 1 << CACHE_SET_BITS;
    localparam integer WORDS = 1 << CACHE_LINE_BITS;
    localparam integer SW    = (CACHE_SET_BITS > 0) ? CACHE_SET_BITS : 1;
    localparam integer LW    = (CACHE_LINE_BITS > 0) ? CACHE_LINE_BITS : 1;
    localparam integer TW    = AW - CACHE_SET_BITS - CACHE_LINE_BITS;  // >= 13
    localparam [LW-1:0] LAST = LW'(WORDS - 1);

    // Requests in flight: one a cycle while the memory answers within 6 cycles.
    localparam integer IN_FLIGHT = (WORDS < 8) ? WORDS : 8;

    // The read that is looked up.
    wire          held;             // there is one
    wire          found;            // with its line
    wire          load;
    wire [AW-1:0] read;
    wire [AW-1:0] line = read >> CACHE_LINE_BITS;
    wire [SW-1:0] set  = SW'(line & AW'(SETS - 1));
    wire [LW-1:0] word = LW'(read & AW'(WORDS - 1));
    wire [TW-1:0] tag  = TW'(line >> CACHE_SET_BITS);

    rp_pipe #(.W(AW), .L(1)) lookup (
        .clk(clk), .rst_n(rst_n),
        .in_valid(in_valid), .in_ready(in_ready), .in_data(address),
        .out_valid(held), .out_ready(out_ready & found), .out_data(read),
        .load(load)
    );

    assign out_valid = held & found;

    // The line that is missing, word by word.
    reg           asked;            // for all of its words
    reg  [LW-1:0] next;             // the word to ask for
    wire          ask = held & ~found & ~asked;
    wire          asking;
    wire          fill;
    wire [LW-1:0] fill_word;
    wire [DW-1:0] fill_data;
    wire          fill_last = fill & (fill_word == LAST);
    wire          unused_read;

    assign word_address = (line << CACHE_LINE_BITS) | AW'(next);

    rp_client #(.DW(DW), .TW(LW), .K(IN_FLIGHT)) fetch (
        .clk(clk), .rst_n(rst_n),
        .in_valid(ask), .in_ready(asking), .in_read(1'b1), .in_tag(next),
        .mem_valid(word_valid), .mem_ready(word_ready),
        .mem_rvalid(word_rvalid), .mem_rready(word_rready), .mem_rdata(word_rdata),
        .out_valid(fill), .out_ready(1'b1), .out_tag(fill_word),
        .out_read(unused_read), .out_data(fill_data)
    );

    always_ff @(posedge clk) begin
        if (!rst_n | fill_last) begin
            asked <= 1'b0;
            next  <= '0;
        end else if (ask & asking) begin
            asked <= next == LAST;
            next  <= next + 1'b1;
        end
    end

    // The ways.
    wire [CACHE_WAYS-1:0]    there, match, chosen;  // chosen: for the next line
    wire [3*CACHE_WAYS-1:0]  number;                // the way's, if it has the line
    wire [DW*CACHE_WAYS-1:0] words;                 // the word, from the way that has it
    wire [2:0]               victim;

    genvar w;
    generate
        for (w = 0; w < CACHE_WAYS; w = w + 1) begin : g_way
            wire [DW-1:0] of_way;

            assign chosen[w] = victim == 3'(w);

            texel_cache_way #(
                .SETS(SETS), .SW(SW), .WORDS(WORDS), .LW(LW), .TW(TW), .DW(DW)
            ) lines (
                .clk(clk), .rst_n(rst_n), .invalidate(load & invalidate),
                .set(set), .word(word), .tag(tag),
                .there(there[w]), .match(match[w]), .data(of_way),
                .fill(fill & chosen[w]), .fill_last(fill_last & chosen[w]),
                .fill_word(fill_word), .fill_data(fill_data)
            );

            assign words[w*DW +: DW] = of_way & {DW{match[w]}};
            assign number[3*w +: 3]  = match[w] ? 3'(w) : 3'd0;
        end
    endgenerate

    assign found = |match;

    texel_cache_any #(.N(CACHE_WAYS)) which (.numbers(number), .number(way));

    texel_cache_order #(
        .SETS(SETS), .SW(SW), .WAYS(CACHE_WAYS), .REPLACEMENT(CACHE_REPLACEMENT)
    ) order (
        .clk(clk), .set(set), .empty(~(|there)),
        .fill(fill_last), .read(out_valid & out_ready), .used(way), .victim(victim)
    );

    // At most one way has the line.
    reg [DW-1:0] merged;
    integer      i;

    always_comb begin
        merged = '0;
        for (i = 0; i < CACHE_WAYS; i = i + 1) merged = merged | words[i*DW +: DW];
    end

    assign data = merged;

    // Of the read that is looked up: was its line missing, and did another one make way?
    reg missed;
    reg replaced;

    always_ff @(posedge clk) begin
        if (load) begin
            missed   <= 1'b0;
            replaced <= 1'b0;
        end else if (fill_last) begin
            missed   <= 1'b1;
            replaced <= |(there & chosen);
        end
    end

    assign hit     = ~missed;
    assign evicted = replaced;
endmodule

`default_nettype wire
