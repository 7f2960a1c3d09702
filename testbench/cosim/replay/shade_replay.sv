`default_nettype none

module shade_replay #(
`include "rtl/units/shade_params.svh"
    , parameter integer COUNT = 1
);
    localparam integer NV = LIGHTS * NORMAL_WIDTH;
    localparam integer LV = LIGHTS * LIGHT_WIDTH;
    localparam integer RW = 3 * POSITION_WIDTH + 3 * LIGHT_WIDTH + 9 + 3 * NV + 6 * LV;
    localparam integer IW = 3 * POSITION_WIDTH + 3 * NORMAL_WIDTH;
    localparam integer OW = 3 * COLOUR_WIDTH;

    wire                    clk, rst_n, in_valid, in_ready, out_valid, out_ready;
    wire [RW+IW+OW-1:0]     line;
    wire [31:0]             unused_eagerness;
    wire [POSITION_WIDTH-1:0] eye_x, eye_y, eye_z, p_x, p_y, p_z;
    wire [LIGHT_WIDTH-1:0]  ambient_red, ambient_green, ambient_blue;
    wire [7:0]              shininess;
    wire                    two_sided;
    wire [NV-1:0]           light_x, light_y, light_z;
    wire [LV-1:0]           diffuse_red, diffuse_green, diffuse_blue;
    wire [LV-1:0]           specular_red, specular_green, specular_blue;
    wire [NORMAL_WIDTH-1:0] n_x, n_y, n_z;
    wire [COLOUR_WIDTH-1:0] red, green, blue;

    replay_stream #(.COUNT(COUNT), .RW(RW), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready),
        .out_valid(out_valid), .out_ready(out_ready), .out_bits({red, green, blue}),
        .out_last(1'b1), .eagerness(unused_eagerness)
    );

    assign {eye_x, eye_y, eye_z, ambient_red, ambient_green, ambient_blue, shininess, two_sided,
            light_x, light_y, light_z, diffuse_red, diffuse_green, diffuse_blue,
            specular_red, specular_green, specular_blue} = line[IW + OW +: RW];
    assign {p_x, p_y, p_z, n_x, n_y, n_z} = line[OW +: IW];

    shade #(
        .POSITION_WIDTH(POSITION_WIDTH), .NORMAL_WIDTH(NORMAL_WIDTH), .NORMAL_FRAC(NORMAL_FRAC),
        .UNNORMALISED_WIDTH(UNNORMALISED_WIDTH),
        .COSINE_WIDTH(COSINE_WIDTH), .COSINE_FRAC(COSINE_FRAC),
        .LIGHT_WIDTH(LIGHT_WIDTH), .LIGHT_FRAC(LIGHT_FRAC),
        .COLOUR_WIDTH(COLOUR_WIDTH), .COLOUR_FRAC(COLOUR_FRAC), .LIGHTS(LIGHTS),
        .POWER_LOG_INDEX_BITS(POWER_LOG_INDEX_BITS), .POWER_EXP_INDEX_BITS(POWER_EXP_INDEX_BITS),
        .NORMALISE_KIND(NORMALISE_KIND), .INVERSE_SQRT_INDEX_BITS(INVERSE_SQRT_INDEX_BITS),
        .INVERSE_SQRT_NEWTON_STEPS(INVERSE_SQRT_NEWTON_STEPS),
        .INVERSE_SQRT_BITS(INVERSE_SQRT_BITS)
    ) unit (
        .clk(clk), .rst_n(rst_n), .eye_x(eye_x), .eye_y(eye_y), .eye_z(eye_z),
        .ambient_red(ambient_red), .ambient_green(ambient_green), .ambient_blue(ambient_blue),
        .shininess(shininess), .two_sided(two_sided),
        .light_x(light_x), .light_y(light_y), .light_z(light_z),
        .diffuse_red(diffuse_red), .diffuse_green(diffuse_green), .diffuse_blue(diffuse_blue),
        .specular_red(specular_red), .specular_green(specular_green),
        .specular_blue(specular_blue),
        .in_valid(in_valid), .in_ready(in_ready),
        .p_x(p_x), .p_y(p_y), .p_z(p_z), .n_x(n_x), .n_y(n_y), .n_z(n_z),
        .out_valid(out_valid), .out_ready(out_ready), .red(red), .green(green), .blue(blue)
    );
endmodule

`default_nettype wire
