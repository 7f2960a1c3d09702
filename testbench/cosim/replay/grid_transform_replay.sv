`default_nettype none

module grid_transform_replay #(
`include "rtl/units/grid_transform_params.svh"
    , parameter integer COUNT = 1
    , parameter integer ENTRIES = 1
);
    // A uniform table's place in the file is part of the line.
    localparam integer PLACE = (Z_TABLE_KIND == 0) ? 21 : 0;
    localparam integer REGS = 3 * CLIP_WIDTH + 2 * FOCAL_WIDTH + STEPS_PER_OCTAVE_WIDTH
                            + 27 + 20 + 6;
    localparam integer RW = REGS + PLACE;
    localparam integer IW = 3 * CLIP_WIDTH + POSITION_WIDTH;
    localparam integer OW = 3 * 22 + INVERSE_W_WIDTH + SWEEP_DATA_WIDTH;

    wire                              clk, rst_n, in_valid, in_ready, out_valid, out_ready;
    wire [RW+IW+OW-1:0]               line;
    wire [31:0]                       unused_eagerness;
    wire [CLIP_WIDTH-1:0]             w_min, w_scale, table_near, x, y, w;
    wire [FOCAL_WIDTH-1:0]            focal_x, focal_y;
    wire [STEPS_PER_OCTAVE_WIDTH-1:0] steps_per_octave;
    wire [26:0]                       log2_near;
    wire [19:0]                       table_scale;
    wire [5:0]                        table_shift;
    wire [POSITION_WIDTH-1:0]         attribute;
    wire [21:0]                       x_grid, y_grid, z_grid;
    wire [INVERSE_W_WIDTH-1:0]        c;
    wire [SWEEP_DATA_WIDTH-1:0]       data;

    replay_stream #(.COUNT(COUNT), .RW(RW), .IW(IW), .OW(OW)) stream (
        .clk(clk), .rst_n(rst_n), .line(line),
        .in_valid(in_valid), .in_ready(in_ready),
        .out_valid(out_valid), .out_ready(out_ready),
        .out_bits({x_grid, y_grid, z_grid, c, data}),
        .out_last(1'b1), .eagerness(unused_eagerness)
    );

    assign {w_min, w_scale, focal_x, focal_y, steps_per_octave, log2_near, table_near,
            table_scale, table_shift} = line[IW + OW + PLACE +: REGS];
    assign {x, y, w, attribute} = line[OW +: IW];

    grid_transform #(
        .POSITION_WIDTH(POSITION_WIDTH), .POSITION_FRAC(POSITION_FRAC),
        .CLIP_WIDTH(CLIP_WIDTH), .CLIP_FRAC(CLIP_FRAC),
        .NDC_WIDTH(NDC_WIDTH), .NDC_FRAC(NDC_FRAC),
        .FOCAL_WIDTH(FOCAL_WIDTH), .FOCAL_FRAC(FOCAL_FRAC),
        .SWEEP_DATA_WIDTH(SWEEP_DATA_WIDTH), .SWEEP_DATA_FRAC(SWEEP_DATA_FRAC),
        .INVERSE_W_WIDTH(INVERSE_W_WIDTH), .INVERSE_W_FRAC(INVERSE_W_FRAC),
        .STEPS_PER_OCTAVE_WIDTH(STEPS_PER_OCTAVE_WIDTH),
        .STEPS_PER_OCTAVE_FRAC(STEPS_PER_OCTAVE_FRAC),
        .Z_TABLE_KIND(Z_TABLE_KIND), .Z_TABLE_INDEX_BITS(Z_TABLE_INDEX_BITS),
        .RECIPROCAL_INDEX_BITS(RECIPROCAL_INDEX_BITS),
        .RECIPROCAL_NEWTON_STEPS(RECIPROCAL_NEWTON_STEPS), .RECIPROCAL_BITS(RECIPROCAL_BITS)
    ) unit (
        .clk(clk), .rst_n(rst_n),
        .w_min(w_min), .w_scale(w_scale), .focal_x(focal_x), .focal_y(focal_y),
        .steps_per_octave(steps_per_octave), .log2_near(log2_near),
        .table_near(table_near), .table_scale(table_scale), .table_shift(table_shift),
        .table_write(1'b0), .table_address({Z_TABLE_INDEX_BITS+1{1'b0}}), .table_data(22'd0),
        .in_valid(in_valid), .in_ready(in_ready),
        .x(x), .y(y), .w(w), .attribute(attribute),
        .out_valid(out_valid), .out_ready(out_ready),
        .x_grid(x_grid), .y_grid(y_grid), .z_grid(z_grid), .c(c), .data(data)
    );

    // Lines of another table wait until the unit is empty; then its words are in place at once.
    generate
        if (Z_TABLE_KIND == 0) begin : g_table
            reg [63:0]       entries [0:ENTRIES-1];
            reg [8*1024-1:0] file;
            integer          i;

            initial begin
                if (!$value$plusargs("tables=%s", file)) $fatal(1, "+tables=FILE is missing");
                $readmemh(file, entries);
            end

            wire [20:0] place = line[IW + OW +: 21];

            always @(negedge clk)
                for (i = 0; i <= (1 << Z_TABLE_INDEX_BITS); i = i + 1)
                    unit.g_uniform.depth.words[i] = entries[place + i][21:0];
        end
    endgenerate
endmodule

`default_nettype wire
