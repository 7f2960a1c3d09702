`default_nettype none

module view_clip_replay #(
`include "rtl/units/view_clip_params.svh"
    , parameter integer COUNT = 1
);
    localparam integer RW = 3 * CLIP_WIDTH + 4 * VIEW_ROW_WIDTH;
    localparam integer IW = 9 * CLIP_WIDTH + DISPLACEMENT_WIDTH;
    localparam integer OW = 7;

    wire                          clk, rst_n, in_valid, in_ready, out_valid, out_ready;
    wire [RW+IW+OW-1:0]           line;
    wire [31:0]                   unused_eagerness;
    wire [CLIP_WIDTH-1:0]         near_w, far_w, margin;
    wire [VIEW_ROW_WIDTH-1:0]     cosine_x, sine_x, cosine_y, sine_y;
    wire [CLIP_WIDTH-1:0]         x1, y1, w1, x2, y2, w2, x3, y3, w3;
    wire [DISPLACEMENT_WIDTH-1:0] max_displacement;
    wire                          reject;
    wire [5:0]                    outside;

    replay_stream #(.COUNT(COUNT), .RW(RW), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready),
        .out_valid(out_valid), .out_ready(out_ready), .out_bits({reject, outside}),
        .out_last(1'b1), .eagerness(unused_eagerness)
    );

    assign {near_w, far_w, cosine_x, sine_x, cosine_y, sine_y, margin} = line[IW + OW +: RW];
    assign {x1, y1, w1, x2, y2, w2, x3, y3, w3, max_displacement} = line[OW +: IW];

    view_clip #(
        .DISPLACEMENT_WIDTH(DISPLACEMENT_WIDTH), .DISPLACEMENT_FRAC(DISPLACEMENT_FRAC),
        .VIEW_ROW_WIDTH(VIEW_ROW_WIDTH), .VIEW_ROW_FRAC(VIEW_ROW_FRAC),
        .CLIP_WIDTH(CLIP_WIDTH), .CLIP_FRAC(CLIP_FRAC)
    ) unit (
        .clk(clk), .rst_n(rst_n),
        .near_w(near_w), .far_w(far_w), .cosine_x(cosine_x), .sine_x(sine_x),
        .cosine_y(cosine_y), .sine_y(sine_y), .margin(margin),
        .in_valid(in_valid), .in_ready(in_ready),
        .x1(x1), .y1(y1), .w1(w1), .x2(x2), .y2(y2), .w2(w2), .x3(x3), .y3(y3), .w3(w3),
        .max_displacement(max_displacement),
        .out_valid(out_valid), .out_ready(out_ready), .reject(reject), .outside(outside)
    );
endmodule

`default_nettype wire
