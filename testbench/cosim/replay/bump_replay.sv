`default_nettype none

module bump_replay #(
`include "rtl/units/bump_params.svh"
    , parameter integer COUNT = 1
    , parameter integer ENTRIES = 1
);
    localparam integer PLACE = 21;  // bits of a table's place in the file
    localparam integer RW = 15 + 15 + 1 + 2 * (25 + 6) + PLACE;
    localparam integer IW = 2 * UV_WIDTH + 6 * NORMAL_WIDTH + 1;
    localparam integer OW = 3 * MAP_NORMAL_WIDTH + 3 * DISPLACED_NORMAL_WIDTH;
    localparam integer XW = (BUMP_KIND == 0) ? 3 * MAP_NORMAL_WIDTH
                          : (BUMP_KIND == 1) ? HEIGHT_WIDTH : 2 * ANGLE_WIDTH;

    wire                              clk, rst_n, in_valid, in_ready, out_valid, out_ready;
    wire [RW+IW+OW-1:0]               line;
    wire [31:0]                       eagerness;
    wire [14:0]                       map_width, map_height;
    wire                              wrap, handedness;
    wire [24:0]                       slope_u_mantissa, slope_v_mantissa;
    wire [5:0]                        slope_u_exponent, slope_v_exponent;
    wire [PLACE-1:0]                  first_entry;
    wire [UV_WIDTH-1:0]               u_x, u_y;
    wire [NORMAL_WIDTH-1:0]           n_x, n_y, n_z, t_x, t_y, t_z;
    wire [MAP_NORMAL_WIDTH-1:0]       map_normal_x, map_normal_y, map_normal_z;
    wire [DISPLACED_NORMAL_WIDTH-1:0] displaced_normal_x, displaced_normal_y, displaced_normal_z;
    wire                              texel_valid, texel_ready, texel_rvalid, texel_rready;
    wire [13:0]                       texel_x, texel_y;
    wire [XW-1:0]                     texel_rdata;

    replay_stream #(.COUNT(COUNT), .RW(RW), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready),
        .out_valid(out_valid), .out_ready(out_ready),
        .out_bits({map_normal_x, map_normal_y, map_normal_z, displaced_normal_x,
                   displaced_normal_y, displaced_normal_z}),
        .out_last(1'b1), .eagerness(eagerness)
    );

    assign {map_width, map_height, wrap, slope_u_mantissa, slope_u_exponent, slope_v_mantissa,
            slope_v_exponent, first_entry} = line[IW + OW +: RW];
    assign {u_x, u_y, n_x, n_y, n_z, t_x, t_y, t_z, handedness} = line[OW +: IW];

    replay_memory #(.DW(XW), .N(1), .AW(14), .ENTRIES(ENTRIES)) memory (
        .clk(clk), .rst_n(rst_n), .eagerness(eagerness),
        .first_entry({11'd0, first_entry}), .columns({17'd0, map_width} + 32'd1),
        .valid(texel_valid), .ready(texel_ready), .read(1'b1), .x(texel_x), .y(texel_y),
        .rvalid(texel_rvalid), .rready(texel_rready), .rdata(texel_rdata)
    );

    bump #(
        .UV_WIDTH(UV_WIDTH), .UV_FRAC(UV_FRAC),
        .HEIGHT_WIDTH(HEIGHT_WIDTH), .HEIGHT_FRAC(HEIGHT_FRAC),
        .MAP_NORMAL_WIDTH(MAP_NORMAL_WIDTH), .MAP_NORMAL_FRAC(MAP_NORMAL_FRAC),
        .NORMAL_WIDTH(NORMAL_WIDTH), .NORMAL_FRAC(NORMAL_FRAC),
        .UNNORMALISED_WIDTH(UNNORMALISED_WIDTH), .UNNORMALISED_FRAC(UNNORMALISED_FRAC),
        .DISPLACED_NORMAL_WIDTH(DISPLACED_NORMAL_WIDTH),
        .DISPLACED_NORMAL_FRAC(DISPLACED_NORMAL_FRAC),
        .BUMP_KIND(BUMP_KIND), .SLOPE_WIDTH(SLOPE_WIDTH), .SLOPE_FRAC(SLOPE_FRAC),
        .ANGLE_WIDTH(ANGLE_WIDTH), .ANGLE_FRAC(ANGLE_FRAC), .SINE_INDEX_BITS(SINE_INDEX_BITS),
        .NORMALISE_KIND(NORMALISE_KIND), .INVERSE_SQRT_INDEX_BITS(INVERSE_SQRT_INDEX_BITS),
        .INVERSE_SQRT_NEWTON_STEPS(INVERSE_SQRT_NEWTON_STEPS),
        .INVERSE_SQRT_BITS(INVERSE_SQRT_BITS)
    ) unit (
        .clk(clk), .rst_n(rst_n),
        .map_width(map_width), .map_height(map_height), .wrap(wrap),
        .slope_u_mantissa(slope_u_mantissa), .slope_u_exponent(slope_u_exponent),
        .slope_v_mantissa(slope_v_mantissa), .slope_v_exponent(slope_v_exponent),
        .in_valid(in_valid), .in_ready(in_ready), .u_x(u_x), .u_y(u_y),
        .n_x(n_x), .n_y(n_y), .n_z(n_z), .t_x(t_x), .t_y(t_y), .t_z(t_z),
        .handedness(handedness),
        .texel_valid(texel_valid), .texel_ready(texel_ready),
        .texel_x(texel_x), .texel_y(texel_y),
        .texel_rvalid(texel_rvalid), .texel_rready(texel_rready), .texel_rdata(texel_rdata),
        .out_valid(out_valid), .out_ready(out_ready),
        .map_normal_x(map_normal_x), .map_normal_y(map_normal_y), .map_normal_z(map_normal_z),
        .displaced_normal_x(displaced_normal_x), .displaced_normal_y(displaced_normal_y),
        .displaced_normal_z(displaced_normal_z)
    );
endmodule

`default_nettype wire
