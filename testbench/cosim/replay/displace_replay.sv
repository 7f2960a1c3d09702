`default_nettype none

module displace_replay #(
`include "rtl/units/displace_params.svh"
    , parameter integer COUNT = 1
    , parameter integer ENTRIES = 1
);
    localparam integer PLACE = 21;  // bits of a table's place in the file
    localparam integer RW = 15 + 15 + 1 + 2 + 2 + 1 + 25 + 6 + DISPLACEMENT_WIDTH + PLACE;
    localparam integer IW = 3 * POSITION_WIDTH + 3 * NORMAL_WIDTH + 4 * UV_WIDTH + 4 + 1;
    localparam integer OW = 3 * POSITION_WIDTH;

    wire                          clk, rst_n, in_valid, in_ready, out_valid, out_ready;
    wire [RW+IW+OW-1:0]           line;
    wire [31:0]                   eagerness;
    wire [14:0]                   map_width, map_height;
    wire                          wrap, minima;
    wire [1:0]                    filter, finer;
    wire [24:0]                   scale_mantissa;
    wire [5:0]                    scale_exponent;
    wire [DISPLACEMENT_WIDTH-1:0] bias;
    wire [PLACE-1:0]              first_entry;
    wire [POSITION_WIDTH-1:0]     p_x, p_y, p_z, displaced_x, displaced_y, displaced_z;
    wire [NORMAL_WIDTH-1:0]       n_x, n_y, n_z;
    wire [UV_WIDTH-1:0]           u_x, u_y, reach_x, reach_y;
    wire [3:0]                    level;
    wire                          back;
    wire                          texel_valid, texel_ready, texel_rvalid, texel_rready;
    wire [13:0]                   texel_x, texel_y;
    wire [3:0]                    texel_level;
    wire                          texel_minimum;
    wire [HEIGHT_WIDTH-1:0]       texel_rdata;

    replay_stream #(.COUNT(COUNT), .RW(RW), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready),
        .out_valid(out_valid), .out_ready(out_ready),
        .out_bits({displaced_x, displaced_y, displaced_z}),
        .out_last(1'b1), .eagerness(eagerness)
    );

    assign {map_width, map_height, wrap, filter, finer, minima, scale_mantissa, scale_exponent,
            bias, first_entry} = line[IW + OW +: RW];
    assign {p_x, p_y, p_z, n_x, n_y, n_z, u_x, u_y, reach_x, reach_y, level, back} = line[OW +: IW];

    // All levels stand below each other in one table of as many columns as the map's, then the
    // minima of levels 1 to 14.
    function automatic [13:0] first_row(
        input [14:0] map_rows,
        input [3:0]  of_level,
        input        minimum
    );
        integer l;
        first_row = 14'd0;
        for (l = 0; l < 15; l = l + 1) begin
            if (l < of_level)
                first_row = first_row + 14'((17'(map_rows) + (17'd1 << l) - 17'd1) >> l);
            if (minimum && l > 0)
                first_row = first_row + 14'((17'(map_rows) + (17'd1 << l) - 17'd1) >> l);
        end
    endfunction

    wire [13:0] table_y = texel_y + first_row(map_height, texel_level, texel_minimum);

    replay_memory #(.DW(HEIGHT_WIDTH), .N(1), .AW(14), .ENTRIES(ENTRIES)) memory (
        .clk(clk), .rst_n(rst_n), .eagerness(eagerness),
        .first_entry({11'd0, first_entry}), .columns({17'd0, map_width} + 32'd1),
        .valid(texel_valid), .ready(texel_ready), .read(1'b1), .x(texel_x), .y(table_y),
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
        .map_width(map_width), .map_height(map_height), .wrap(wrap), .filter(filter),
        .finer(finer), .minima(minima),
        .scale_mantissa(scale_mantissa), .scale_exponent(scale_exponent), .bias(bias),
        .in_valid(in_valid), .in_ready(in_ready),
        .p_x(p_x), .p_y(p_y), .p_z(p_z), .n_x(n_x), .n_y(n_y), .n_z(n_z), .u_x(u_x), .u_y(u_y),
        .reach_x(reach_x), .reach_y(reach_y), .level(level), .back(back),
        .texel_valid(texel_valid), .texel_ready(texel_ready),
        .texel_x(texel_x), .texel_y(texel_y),
        .texel_level(texel_level), .texel_minimum(texel_minimum),
        .texel_rvalid(texel_rvalid), .texel_rready(texel_rready), .texel_rdata(texel_rdata),
        .out_valid(out_valid), .out_ready(out_ready),
        .displaced_x(displaced_x), .displaced_y(displaced_y), .displaced_z(displaced_z)
    );
endmodule

`default_nettype wire
