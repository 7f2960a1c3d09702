`default_nettype none

module displace_replay #(
`include "rtl/units/displace_params.svh"
    , parameter integer COUNT = 1
    , parameter integer ENTRIES = 1
);
    localparam integer PLACE = 21;  // bits of a table's place in the file
    localparam integer RW = 15 + 15 + 2 + 25 + 6 + DISPLACEMENT_WIDTH + PLACE;
    localparam integer IW = 3 * POSITION_WIDTH + 3 * NORMAL_WIDTH + 2 * UV_WIDTH;
    localparam integer OW = 3 * POSITION_WIDTH;

    wire                          clk, rst_n, in_valid, in_ready, out_valid, out_ready;
    wire [RW+IW+OW-1:0]           line;
    wire [31:0]                   eagerness;
    wire [14:0]                   map_width, map_height;
    wire                          wrap, bilinear;
    wire [24:0]                   scale_mantissa;
    wire [5:0]                    scale_exponent;
    wire [DISPLACEMENT_WIDTH-1:0] bias;
    wire [PLACE-1:0]              first_entry;
    wire [POSITION_WIDTH-1:0]     p_x, p_y, p_z, displaced_x, displaced_y, displaced_z;
    wire [NORMAL_WIDTH-1:0]       n_x, n_y, n_z;
    wire [UV_WIDTH-1:0]           u_x, u_y;
    wire                          texel_valid, texel_ready, texel_rvalid, texel_rready;
    wire [13:0]                   texel_x, texel_y;
    wire [HEIGHT_WIDTH-1:0]       texel_rdata;

    replay_stream #(.COUNT(COUNT), .RW(RW), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready),
        .out_valid(out_valid), .out_ready(out_ready),
        .out_bits({displaced_x, displaced_y, displaced_z}),
        .eagerness(eagerness)
    );

    assign {map_width, map_height, wrap, bilinear, scale_mantissa, scale_exponent, bias,
            first_entry} = line[IW + OW +: RW];
    assign {p_x, p_y, p_z, n_x, n_y, n_z, u_x, u_y} = line[OW +: IW];

    replay_memory #(.DW(HEIGHT_WIDTH), .N(1), .AW(14), .ENTRIES(ENTRIES)) memory (
        .clk(clk), .rst_n(rst_n), .eagerness(eagerness),
        .first_entry({11'd0, first_entry}), .columns({17'd0, map_width} + 32'd1),
        .valid(texel_valid), .ready(texel_ready), .read(1'b1), .x(texel_x), .y(texel_y),
        .rvalid(texel_rvalid), .rready(texel_rready), .rdata(texel_rdata)
    );

    displace #(
        .UV_WIDTH(UV_WIDTH), .UV_FRAC(UV_FRAC),
        .HEIGHT_WIDTH(HEIGHT_WIDTH), .HEIGHT_FRAC(HEIGHT_FRAC),
        .FILTERED_HEIGHT_WIDTH(FILTERED_HEIGHT_WIDTH),
        .FILTERED_HEIGHT_FRAC(FILTERED_HEIGHT_FRAC),
        .DISPLACEMENT_WIDTH(DISPLACEMENT_WIDTH), .DISPLACEMENT_FRAC(DISPLACEMENT_FRAC),
        .POSITION_WIDTH(POSITION_WIDTH), .POSITION_FRAC(POSITION_FRAC),
        .NORMAL_WIDTH(NORMAL_WIDTH), .NORMAL_FRAC(NORMAL_FRAC)
    ) unit (
        .clk(clk), .rst_n(rst_n),
        .map_width(map_width), .map_height(map_height), .wrap(wrap), .bilinear(bilinear),
        .scale_mantissa(scale_mantissa), .scale_exponent(scale_exponent), .bias(bias),
        .in_valid(in_valid), .in_ready(in_ready),
        .p_x(p_x), .p_y(p_y), .p_z(p_z), .n_x(n_x), .n_y(n_y), .n_z(n_z), .u_x(u_x), .u_y(u_y),
        .texel_valid(texel_valid), .texel_ready(texel_ready),
        .texel_x(texel_x), .texel_y(texel_y),
        .texel_rvalid(texel_rvalid), .texel_rready(texel_rready), .texel_rdata(texel_rdata),
        .out_valid(out_valid), .out_ready(out_ready),
        .displaced_x(displaced_x), .displaced_y(displaced_y), .displaced_z(displaced_z)
    );
endmodule

`default_nettype wire
