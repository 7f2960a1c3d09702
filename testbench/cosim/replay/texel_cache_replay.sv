`default_nettype none

module texel_cache_replay #(
`include "rtl/units/texel_cache_params.svh"
    , parameter integer COUNT = 1
    , parameter integer ENTRIES = 1
);
    localparam integer PLACE = 21;  // bits of a table's place in the file
    localparam integer RW = PLACE;
    localparam integer IW = 1 + 30;
    localparam integer OW = HEIGHT_WIDTH + 1 + 3 + 1;

    wire                    clk, rst_n, in_valid, in_ready, out_valid, out_ready;
    wire [RW+IW+OW-1:0]     line;
    wire [31:0]             eagerness;
    wire [PLACE-1:0]        first_entry;
    wire                    invalidate, hit, evicted;
    wire [29:0]             address, word_address;
    wire [2:0]              way;
    wire                    word_valid, word_ready, word_rvalid, word_rready;
    wire [HEIGHT_WIDTH-1:0] word_rdata, data;

    replay_stream #(.COUNT(COUNT), .RW(RW), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready),
        .out_valid(out_valid), .out_ready(out_ready),
        .out_bits({data, hit, way, evicted}),
        .out_last(1'b1), .eagerness(eagerness)
    );

    assign first_entry           = line[IW + OW +: RW];
    assign {invalidate, address} = line[OW +: IW];

    // A table of 64 x 64 entries behind 2^30 addresses: folded, so that every bit of an address
    // makes a difference to what is read.
    wire [11:0] folded = word_address[11:0] ^ word_address[23:12] ^ {6'd0, word_address[29:24]};

    replay_memory #(.DW(HEIGHT_WIDTH), .N(1), .AW(6), .ENTRIES(ENTRIES)) memory (
        .clk(clk), .rst_n(rst_n), .eagerness(eagerness),
        .first_entry({11'd0, first_entry}), .columns(32'd64),
        .valid(word_valid), .ready(word_ready), .read(1'b1), .x(folded[5:0]), .y(folded[11:6]),
        .rvalid(word_rvalid), .rready(word_rready), .rdata(word_rdata)
    );

    texel_cache #(
        .HEIGHT_WIDTH(HEIGHT_WIDTH), .HEIGHT_FRAC(HEIGHT_FRAC),
        .CACHE_LINE_BITS(CACHE_LINE_BITS), .CACHE_SET_BITS(CACHE_SET_BITS),
        .CACHE_WAYS(CACHE_WAYS), .CACHE_REPLACEMENT(CACHE_REPLACEMENT)
    ) unit (
        .clk(clk), .rst_n(rst_n),
        .in_valid(in_valid), .in_ready(in_ready), .invalidate(invalidate), .address(address),
        .word_valid(word_valid), .word_ready(word_ready), .word_address(word_address),
        .word_rvalid(word_rvalid), .word_rready(word_rready), .word_rdata(word_rdata),
        .out_valid(out_valid), .out_ready(out_ready),
        .data(data), .hit(hit), .way(way), .evicted(evicted)
    );
endmodule

`default_nettype wire
