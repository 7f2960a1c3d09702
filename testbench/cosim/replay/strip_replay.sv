`default_nettype none

// Vertices are numbers here. Triangles that were not made are undefined, and 0 in the file.
module strip_replay #(
`include "rtl/units/strip_params.svh"
    , parameter integer COUNT = 1
);
    localparam integer W  = 32;
    localparam integer IW = 3 + 3 + 4 * 6 + 4 * W;
    localparam integer OW = 2 + 1 + 6 * W;

    wire             clk, rst_n, in_valid, in_ready, out_valid, out_ready;
    wire [IW+OW-1:0] line;
    wire [31:0]      unused_eagerness;
    wire             flush, init, flip, bad_ref;
    wire [2:0]       count;
    wire [5:0]       command0, command1, command2, command3;
    wire [W-1:0]     vertex0, vertex1, vertex2, vertex3;
    wire [1:0]       triangles;
    wire [W-1:0]     a0, b0, c0, a1, b1, c1;

    replay_stream #(.COUNT(COUNT), .RW(0), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready),
        .out_valid(out_valid), .out_ready(out_ready),
        .out_bits({triangles, bad_ref,
                   (triangles > 2'd0) ? {a0, b0, c0} : {(3*W){1'b0}},
                   (triangles > 2'd1) ? {a1, b1, c1} : {(3*W){1'b0}}}),
        .out_last(1'b1), .eagerness(unused_eagerness)
    );

    assign {flush, init, flip, count, command0, command1, command2, command3,
            vertex0, vertex1, vertex2, vertex3} = line[OW +: IW];

    strip #(.COLUMN_DEPTH(COLUMN_DEPTH), .VERTEX_WIDTH(W)) unit (
        .clk(clk), .rst_n(rst_n), .in_valid(in_valid), .in_ready(in_ready),
        .flush(flush), .init(init), .flip(flip), .count(count),
        .command0(command0), .command1(command1), .command2(command2), .command3(command3),
        .vertex0(vertex0), .vertex1(vertex1), .vertex2(vertex2), .vertex3(vertex3),
        .out_valid(out_valid), .out_ready(out_ready), .triangles(triangles), .bad_ref(bad_ref),
        .a0(a0), .b0(b0), .c0(c0), .a1(a1), .b1(b1), .c1(c1)
    );
endmodule

`default_nettype wire
