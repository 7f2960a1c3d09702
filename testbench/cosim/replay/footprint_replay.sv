`default_nettype none

module footprint_replay #(
`include "rtl/units/footprint_params.svh"
    , parameter integer COUNT = 1
);
    localparam integer RW = 15 + 15 + 4 + 2 + 3 * POSITION_WIDTH;
    localparam integer IW = 2 + 3 * POSITION_WIDTH + 3 * NORMAL_WIDTH + 2 * UV_WIDTH
                          + 3 * INVERSE_W_WIDTH + 4 * SWEEP_DATA_WIDTH;
    localparam integer OW = 2 * UV_WIDTH + 4 + 1;

    wire                        clk, rst_n, in_valid, in_ready, out_valid, out_ready;
    wire [RW+IW+OW-1:0]         line;
    wire [31:0]                 unused_eagerness;
    wire [14:0]                 map_width, map_height;
    wire [3:0]                  last_level, level;
    wire [POSITION_WIDTH-1:0]   eye_x, eye_y, eye_z, p_x, p_y, p_z;
    wire [NORMAL_WIDTH-1:0]     n_x, n_y, n_z;
    wire [UV_WIDTH-1:0]         u_x, u_y, reach_x, reach_y;
    wire [INVERSE_W_WIDTH-1:0]  c, step0_c, step1_c;
    wire [SWEEP_DATA_WIDTH-1:0] step0_u, step0_v, step1_u, step1_v;
    wire [1:0]                  kind, finer;
    wire                        back;

    replay_stream #(.COUNT(COUNT), .RW(RW), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready),
        .out_valid(out_valid), .out_ready(out_ready),
        .out_bits({reach_x, reach_y, level, back}),
        .out_last(1'b1), .eagerness(unused_eagerness)
    );

    assign {map_width, map_height, last_level, finer, eye_x, eye_y, eye_z} = line[IW + OW +: RW];
    assign {kind, p_x, p_y, p_z, n_x, n_y, n_z, u_x, u_y, c, step0_u, step0_v, step0_c, step1_u,
            step1_v, step1_c} = line[OW +: IW];

    footprint #(
        .UV_WIDTH(UV_WIDTH), .UV_FRAC(UV_FRAC),
        .POSITION_WIDTH(POSITION_WIDTH), .POSITION_FRAC(POSITION_FRAC),
        .NORMAL_WIDTH(NORMAL_WIDTH), .NORMAL_FRAC(NORMAL_FRAC),
        .SWEEP_DATA_WIDTH(SWEEP_DATA_WIDTH), .SWEEP_DATA_FRAC(SWEEP_DATA_FRAC),
        .INVERSE_W_WIDTH(INVERSE_W_WIDTH), .INVERSE_W_FRAC(INVERSE_W_FRAC),
        .RECIPROCAL_INDEX_BITS(RECIPROCAL_INDEX_BITS),
        .RECIPROCAL_NEWTON_STEPS(RECIPROCAL_NEWTON_STEPS), .RECIPROCAL_BITS(RECIPROCAL_BITS)
    ) unit (
        .clk(clk), .rst_n(rst_n),
        .map_width(map_width), .map_height(map_height), .last_level(last_level),
        .finer(finer),
        .eye_x(eye_x), .eye_y(eye_y), .eye_z(eye_z),
        .in_valid(in_valid), .in_ready(in_ready),
        .kind(kind), .p_x(p_x), .p_y(p_y), .p_z(p_z), .n_x(n_x), .n_y(n_y), .n_z(n_z),
        .u_x(u_x), .u_y(u_y), .c(c),
        .step0_u(step0_u), .step0_v(step0_v), .step0_c(step0_c),
        .step1_u(step1_u), .step1_v(step1_v), .step1_c(step1_c),
        .out_valid(out_valid), .out_ready(out_ready),
        .reach_x(reach_x), .reach_y(reach_y), .level(level), .back(back)
    );
endmodule

`default_nettype wire
