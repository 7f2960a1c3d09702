`default_nettype none

module edge_iter_replay #(
    parameter integer COUNT = 1,
    parameter integer BEATS = 1
);
    localparam integer RW = 4;
    localparam integer IW = 15;
    localparam integer OW = 4;

    wire             clk, rst_n, in_valid, in_ready, out_valid, out_ready;
    wire [RW+IW-1:0] line;
    wire [31:0]      unused_eagerness;
    wire [3:0]       cap, generation1, generation2, generation3;
    wire [2:0]       unsplit;
    wire [1:0]       number;
    wire             eligible, last, unused_load;

    replay_stream #(.COUNT(COUNT), .BEATS(BEATS), .RW(RW), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready),
        .out_valid(out_valid), .out_ready(out_ready),
        .out_bits({number, eligible, last}), .out_last(last),
        .eagerness(unused_eagerness)
    );

    assign {cap, generation1, generation2, generation3, unsplit} = line;

    edge_iter unit (
        .clk(clk), .rst_n(rst_n), .cap(cap),
        .in_valid(in_valid), .in_ready(in_ready),
        .generation1(generation1), .generation2(generation2), .generation3(generation3),
        .unsplit(unsplit),
        .out_valid(out_valid), .out_ready(out_ready),
        .number(number), .eligible(eligible), .last(last), .load(unused_load)
    );
endmodule

`default_nettype wire
