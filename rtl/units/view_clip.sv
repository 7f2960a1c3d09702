`default_nettype none

// Conservative clipping to the extended view volume (Gumhold and Huettner 3.2, equations 7 and 8):
// a triangle is rejected if all its corners lie beyond one plane of the view by more than any
// displacement reaches.
//
// Stage 0: products with the planes' sines and cosines, distances from near and far, the reach.
// Stage 1: each corner against each plane. Stage 2: the three corners together.
//
// Time: latency 3, one triangle a cycle, in_ready follows out_ready.
module view_clip #(
`include "rtl/units/view_clip_params.svh"
) (
    input  wire                                 clk,
    input  wire                                 rst_n,      // synchronous, low

    // Registers, stable while triangles are in the unit.
    input  wire signed [CLIP_WIDTH-1:0]         near_w,     // least distance along the view
    input  wire signed [CLIP_WIDTH-1:0]         far_w,      // greatest
    input  wire signed [VIEW_ROW_WIDTH-1:0]     cosine_x,   // of half the horizontal view angle
    input  wire signed [VIEW_ROW_WIDTH-1:0]     sine_x,
    input  wire signed [VIEW_ROW_WIDTH-1:0]     cosine_y,   // of half the vertical one
    input  wire signed [VIEW_ROW_WIDTH-1:0]     sine_y,
    input  wire signed [CLIP_WIDTH-1:0]         margin,     // for what was rounded before

    input  wire                                 in_valid,
    output wire                                 in_ready,
    input  wire signed [CLIP_WIDTH-1:0]         x1,         // corner 1 in eye space
    input  wire signed [CLIP_WIDTH-1:0]         y1,
    input  wire signed [CLIP_WIDTH-1:0]         w1,         // along the view
    input  wire signed [CLIP_WIDTH-1:0]         x2,
    input  wire signed [CLIP_WIDTH-1:0]         y2,
    input  wire signed [CLIP_WIDTH-1:0]         w2,
    input  wire signed [CLIP_WIDTH-1:0]         x3,
    input  wire signed [CLIP_WIDTH-1:0]         y3,
    input  wire signed [CLIP_WIDTH-1:0]         w3,
    input  wire signed [DISPLACEMENT_WIDTH-1:0] max_displacement,

    output wire                                 out_valid,
    input  wire                                 out_ready,
    output wire                                 reject,     // beyond some plane
    output wire        [5:0]                    outside     // which: left, right, bottom, top,
                                                            // near, far from bit 0 on
);
    // The reach is d_max in the LSB of `clip`, rounded up, plus the margin: one bit more than the
    // wider of the two.
    localparam integer RISE    = CLIP_FRAC - DISPLACEMENT_FRAC;
    localparam integer GAINED  = (RISE > 0) ? RISE : 0;
    localparam integer DROPPED = (RISE < 0) ? -RISE : 0;
    localparam integer DW      = DISPLACEMENT_WIDTH + GAINED;
    localparam integer RW      = ((DW > CLIP_WIDTH) ? DW : CLIP_WIDTH) + 2;

    wire [2:0] load;
    wire       unused_data;

    rp_pipe #(.W(1), .L(3)) stages (
        .clk      (clk),
        .rst_n    (rst_n),
        .in_valid (in_valid),
        .in_ready (in_ready),
        .in_data  (1'b0),
        .out_valid(out_valid),
        .out_ready(out_ready),
        .out_data (unused_data),
        .load     (load)
    );

    // The negative is floored, so that d_max itself is rounded up.
    wire signed [RW-1:0] wide     = RW'(max_displacement);
    wire signed [RW-1:0] negative = (-wide) <<< GAINED;
    reg  signed [RW-1:0] reach;

    always_ff @(posedge clk) if (load[0]) reach <= RW'(margin) - (negative >>> DROPPED);

    wire [5:0] beyond1, beyond2, beyond3;

    view_clip_corner #(
        .CW(CLIP_WIDTH), .VW(VIEW_ROW_WIDTH), .VF(VIEW_ROW_FRAC), .RW(RW)
    ) corner1 (
        .clk(clk), .load(load[1:0]),
        .near_w(near_w), .far_w(far_w), .cosine_x(cosine_x), .sine_x(sine_x),
        .cosine_y(cosine_y), .sine_y(sine_y),
        .x(x1), .y(y1), .w(w1), .reach(reach), .beyond(beyond1)
    );
    view_clip_corner #(
        .CW(CLIP_WIDTH), .VW(VIEW_ROW_WIDTH), .VF(VIEW_ROW_FRAC), .RW(RW)
    ) corner2 (
        .clk(clk), .load(load[1:0]),
        .near_w(near_w), .far_w(far_w), .cosine_x(cosine_x), .sine_x(sine_x),
        .cosine_y(cosine_y), .sine_y(sine_y),
        .x(x2), .y(y2), .w(w2), .reach(reach), .beyond(beyond2)
    );
    view_clip_corner #(
        .CW(CLIP_WIDTH), .VW(VIEW_ROW_WIDTH), .VF(VIEW_ROW_FRAC), .RW(RW)
    ) corner3 (
        .clk(clk), .load(load[1:0]),
        .near_w(near_w), .far_w(far_w), .cosine_x(cosine_x), .sine_x(sine_x),
        .cosine_y(cosine_y), .sine_y(sine_y),
        .x(x3), .y(y3), .w(w3), .reach(reach), .beyond(beyond3)
    );

    // Stage 2.
    reg [5:0] planes;

    always_ff @(posedge clk) if (load[2]) planes <= beyond1 & beyond2 & beyond3;

    assign outside = planes;
    assign reject  = |planes;
endmodule

`default_nettype wire
