`default_nettype none

// The vertex-grid transform lookup (Gumhold and Huettner 1999, section 3.1, equations 2 to 4): a
// vertex in eye space to a place on the grid, whose voxels are as deep as a pixel is wide there,
// and c = w_scale / w, by which vertex data are multiplied before the sweep line interpolates them.
//
// Stage 0: w is clamped to w_min. Stages 1 to 8: 1/w (rp_reciprocal). Stage 9: x, y and
// min(w_scale, w) times 1/w; stage 10: to x/w, y/w and c. Stage 11: times the focal lengths; stage
// 12: to x_grid, y_grid. Stages 9 to 14, beside them: z_grid from w, by octaves or from the
// uniform table. Stages 13, 14: attribute times c, the one lane of `scale` that is built here.
//
// Every rounding is SC_RND, every output saturates. The uniform table (Z_TABLE_KIND 0) is written
// word by word while the unit is empty; the other kinds have a ROM and leave these ports alone.
//
// Time: latency 15, one item a cycle, in_ready follows out_ready.
module grid_transform #(
`include "rtl/units/grid_transform_params.svh"
) (
    input  wire                                    clk,
    input  wire                                    rst_n,   // synchronous, low

    // Registers, stable while items are in the unit.
    input  wire signed [CLIP_WIDTH-1:0]            w_min,   // > 0
    input  wire signed [CLIP_WIDTH-1:0]            w_scale, // > 0
    input  wire signed [FOCAL_WIDTH-1:0]           focal_x, // grid units per unit of x/w
    input  wire signed [FOCAL_WIDTH-1:0]           focal_y,
    input  wire        [STEPS_PER_OCTAVE_WIDTH-1:0] steps_per_octave,  // K
    input  wire signed [26:0]                      log2_near,          // s6.20
    input  wire signed [CLIP_WIDTH-1:0]            table_near,    // these three: uniform table only
    input  wire        [19:0]                      table_scale,
    input  wire        [5:0]                       table_shift,

    // The uniform table: word `table_address` of 2^Z_TABLE_INDEX_BITS + 1, u14.8.
    input  wire                                    table_write,
    input  wire        [Z_TABLE_INDEX_BITS:0]      table_address,
    input  wire        [21:0]                      table_data,

    input  wire                                    in_valid,
    output wire                                    in_ready,
    input  wire signed [CLIP_WIDTH-1:0]            x,       // a vertex in eye space
    input  wire signed [CLIP_WIDTH-1:0]            y,
    input  wire signed [CLIP_WIDTH-1:0]            w,
    input  wire signed [POSITION_WIDTH-1:0]        attribute,

    output wire                                    out_valid,
    input  wire                                    out_ready,
    output wire signed [21:0]                      x_grid,  // s15.6
    output wire signed [21:0]                      y_grid,
    output wire signed [21:0]                      z_grid,
    output wire signed [INVERSE_W_WIDTH-1:0]       c,       // w_scale / w, at most 1
    output wire signed [SWEEP_DATA_WIDTH-1:0]      data     // attribute * c
);
    localparam integer CW    = CLIP_WIDTH;
    localparam integer BITS  = RECIPROCAL_BITS;
    localparam integer PRODW = CW + BITS + 1;                     // x * mantissa, with its sign
    localparam integer GRIDW = NDC_WIDTH + FOCAL_WIDTH;           // ratio * focal length
    localparam integer DATAW = POSITION_WIDTH + INVERSE_W_WIDTH;  // attribute * c
    localparam integer GRID_FRAC = 6;

    wire [14:0] load;                  // register enables
    wire        unused_flag;

    rp_pipe #(.W(1), .L(15)) stages (
        .clk      (clk),
        .rst_n    (rst_n),
        .in_valid (in_valid),
        .in_ready (in_ready),
        .in_data  (1'b0),
        .out_valid(out_valid),
        .out_ready(out_ready),
        .out_data (unused_flag),
        .load     (load)
    );

    // Stage 0: a w > 0.
    reg signed [CW-1:0] w0;

    always_ff @(posedge clk) if (load[0]) w0 <= (w < w_min) ? w_min : w;

    // Stages 1 to 8: 1/w. CLIP_WIDTH - 1 bits hold a positive w.
    wire [BITS-1:0] mantissa;
    wire [5:0]      exponent;

    rp_reciprocal #(
        .W(CW - 1), .INDEX_BITS(RECIPROCAL_INDEX_BITS), .NEWTON_STEPS(RECIPROCAL_NEWTON_STEPS),
        .BITS(BITS)
    ) reciprocal (
        .clk(clk), .load(load[8:1]), .x(w0[CW-2:0]), .mantissa(mantissa), .exponent(exponent)
    );

    // What waits for it.
    wire signed [CW-1:0]             x8, y8, w8;
    wire signed [POSITION_WIDTH-1:0] attribute12;

    rp_delay #(.W(2 * CW), .L(9)) wait_xy (
        .clk(clk), .load(load[8:0]), .in_data({x, y}), .out_data({x8, y8})
    );
    rp_delay #(.W(CW), .L(8)) wait_w (
        .clk(clk), .load(load[8:1]), .in_data(w0), .out_data(w8)
    );
    rp_delay #(.W(POSITION_WIDTH), .L(13)) wait_attribute (
        .clk(clk), .load(load[12:0]), .in_data(attribute), .out_data(attribute12)
    );

    // Stage 9: products with the mantissa. The dividend of c is never above w.
    wire signed [BITS:0]   factor   = $signed({1'b0, mantissa});
    wire signed [CW-1:0]   dividend = (w_scale < w8) ? w_scale : w8;
    reg signed [PRODW-1:0] x9, y9, c9;
    reg [5:0]              exponent9;

    always_ff @(posedge clk) begin
        if (load[9]) begin
            x9        <= PRODW'(x8) * PRODW'(factor);
            y9        <= PRODW'(y8) * PRODW'(factor);
            c9        <= PRODW'(dividend) * PRODW'(factor);
            exponent9 <= exponent;
        end
    end

    // Stage 10: x/w, y/w, c. Rounding may leave c an LSB above 1.
    localparam signed [INVERSE_W_WIDTH-1:0] ONE = INVERSE_W_WIDTH'(1) <<< INVERSE_W_FRAC;

    wire signed [NDC_WIDTH-1:0]       ratio_x, ratio_y;
    wire signed [INVERSE_W_WIDTH-1:0] quotient;
    reg signed [NDC_WIDTH-1:0]        x10, y10;
    reg signed [INVERSE_W_WIDTH-1:0]  c10;

    rp_scaled_cast #(
        .W(PRODW), .LEAST(BITS - 1), .MOST(BITS + 30), .OFFSET(-NDC_FRAC), .OW(NDC_WIDTH)
    ) to_ratio_x (.x(x9), .exponent(exponent9), .y(ratio_x));
    rp_scaled_cast #(
        .W(PRODW), .LEAST(BITS - 1), .MOST(BITS + 30), .OFFSET(-NDC_FRAC), .OW(NDC_WIDTH)
    ) to_ratio_y (.x(y9), .exponent(exponent9), .y(ratio_y));
    rp_scaled_cast #(
        .W(PRODW), .LEAST(BITS - 1), .MOST(BITS + 30), .OFFSET(-INVERSE_W_FRAC),
        .OW(INVERSE_W_WIDTH)
    ) to_c (.x(c9), .exponent(exponent9), .y(quotient));

    always_ff @(posedge clk) begin
        if (load[10]) begin
            x10 <= ratio_x;
            y10 <= ratio_y;
            c10 <= (quotient > ONE) ? ONE : quotient;
        end
    end

    // Stages 11 and 12: to the grid.
    reg signed [GRIDW-1:0] x11, y11;
    wire signed [21:0]     x_rounded, y_rounded;
    reg signed [21:0]      x12, y12;

    rp_cast #(.W(GRIDW), .SHIFT(NDC_FRAC + FOCAL_FRAC - GRID_FRAC), .OW(22)) to_x (
        .x(x11), .y(x_rounded)
    );
    rp_cast #(.W(GRIDW), .SHIFT(NDC_FRAC + FOCAL_FRAC - GRID_FRAC), .OW(22)) to_y (
        .x(y11), .y(y_rounded)
    );

    always_ff @(posedge clk) begin
        if (load[11]) begin
            x11 <= GRIDW'(x10) * GRIDW'(focal_x);
            y11 <= GRIDW'(y10) * GRIDW'(focal_y);
        end
        if (load[12]) begin
            x12 <= x_rounded;
            y12 <= y_rounded;
        end
    end

    rp_delay #(.W(44), .L(2)) wait_grid (
        .clk(clk), .load(load[14:13]), .in_data({x12, y12}), .out_data({x_grid, y_grid})
    );

    // Stages 9 to 14: z_grid.
    generate
        if (Z_TABLE_KIND == 0) begin : g_uniform
            grid_transform_uniform #(.CW(CW), .INDEX_BITS(Z_TABLE_INDEX_BITS)) depth (
                .clk(clk), .load(load[14:9]),
                .table_near(table_near), .table_scale(table_scale), .table_shift(table_shift),
                .table_write(table_write), .table_address(table_address), .table_data(table_data),
                .w(w8), .z(z_grid)
            );
            wire unused_octave = &{1'b0, steps_per_octave, log2_near};
        end else begin : g_octave
            grid_transform_octave #(
                .CW(CW), .CLIP_FRAC(CLIP_FRAC), .QUADRATIC(Z_TABLE_KIND == 2 ? 1 : 0),
                .INDEX_BITS(Z_TABLE_INDEX_BITS),
                .KW(STEPS_PER_OCTAVE_WIDTH), .K_FRAC(STEPS_PER_OCTAVE_FRAC)
            ) depth (
                .clk(clk), .load(load[14:9]),
                .steps_per_octave(steps_per_octave), .log2_near(log2_near), .w(w8), .z(z_grid)
            );
            wire unused_uniform = &{1'b0, table_near, table_scale, table_shift,
                                    table_write, table_address, table_data};
        end
    endgenerate

    // Stages 13 and 14: attribute times c.
    wire signed [INVERSE_W_WIDTH-1:0] c12;
    reg signed [DATAW-1:0]            data13;
    wire signed [SWEEP_DATA_WIDTH-1:0] data_rounded;
    reg signed [SWEEP_DATA_WIDTH-1:0] data14;

    rp_delay #(.W(INVERSE_W_WIDTH), .L(2)) wait_c (
        .clk(clk), .load(load[12:11]), .in_data(c10), .out_data(c12)
    );
    rp_delay #(.W(INVERSE_W_WIDTH), .L(2)) c_out (
        .clk(clk), .load(load[14:13]), .in_data(c12), .out_data(c)
    );
    rp_cast #(
        .W(DATAW), .SHIFT(POSITION_FRAC + INVERSE_W_FRAC - SWEEP_DATA_FRAC), .OW(SWEEP_DATA_WIDTH)
    ) to_data (.x(data13), .y(data_rounded));

    always_ff @(posedge clk) begin
        if (load[13]) data13 <= DATAW'(attribute12) * DATAW'(c12);
        if (load[14]) data14 <= data_rounded;
    end

    assign data = data14;
endmodule

`default_nettype wire
