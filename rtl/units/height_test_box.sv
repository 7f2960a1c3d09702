`default_nettype none

// One of the three boxes of the Summed Height Test: its corners, its area, and the entries of the
// summed-area table that make up its sum.
//
// Stage 1: centre. Stages 2, 3: sides (height_test_side). Stage 4: the item that is being read,
// column by column and row by row. The stages are enabled from outside.
module height_test_box #(
    parameter integer UV_WIDTH = 23,  // bits of a texture coordinate
    parameter integer UV_FRAC  = 8,   // of which fraction
    parameter integer AW       = 23   // bits of an area
) (
    input  wire                       clk,
    input  wire [2:0]                 load,         // register enables of stages 1 to 3
    input  wire                       load_item,    // of stage 4

    // Registers of the unit.
    input  wire [12:0]                map_width,
    input  wire [12:0]                map_height,
    input  wire                       wrap,
    input  wire                       sum,

    // Stage 1.
    input  wire signed [UV_WIDTH-1:0] u_x,          // the vertex
    input  wire signed [UV_WIDTH-1:0] u_y,

    // Stage 2.
    input  wire        [UV_WIDTH-3:0] half_x,       // half-extents, registered by the user
    input  wire        [UV_WIDTH-3:0] half_y,

    // After stage 3.
    output wire                       x_seam,       // crosses a seam: reads a third column
    output wire                       y_seam,       // reads a third row
    output wire [AW-1:0]              area,         // texel^2

    // Stage 4: the entry for one column and one row of the item. 0: hi, 1: lo, 2: the last one.
    input  wire [1:0]                 column,
    input  wire [1:0]                 row,
    output wire                       wanted,       // the sum has such an entry
    output wire [12:0]                entry_x,      // its coordinates, 0..W and 0..H
    output wire [12:0]                entry_y
);
    reg signed [UV_WIDTH-1:0] centre_x, centre_y;

    always_ff @(posedge clk) begin
        if (load[0]) begin
            centre_x <= u_x;
            centre_y <= u_y;
        end
    end

    wire [12:0] x_lo, x_hi, x_texels;
    wire [12:0] y_lo, y_hi, y_texels;

    height_test_side #(.UV_WIDTH(UV_WIDTH), .UV_FRAC(UV_FRAC)) side_x (
        .clk   (clk),
        .load  (load[2:1]),
        .size  (map_width),
        .wrap  (wrap),
        .sum   (sum),
        .centre(centre_x),
        .half  (half_x),
        .lo    (x_lo),
        .hi    (x_hi),
        .texels(x_texels),
        .seam  (x_seam)
    );

    height_test_side #(.UV_WIDTH(UV_WIDTH), .UV_FRAC(UV_FRAC)) side_y (
        .clk   (clk),
        .load  (load[2:1]),
        .size  (map_height),
        .wrap  (wrap),
        .sum   (sum),
        .centre(centre_y),
        .half  (half_y),
        .lo    (y_lo),
        .hi    (y_hi),
        .texels(y_texels),
        .seam  (y_seam)
    );

    assign area = AW'(x_texels * y_texels);

    reg [12:0] column_lo, column_hi;
    reg [12:0] row_lo, row_hi;
    reg        third_column, third_row;

    always_ff @(posedge clk) begin
        if (load_item) begin
            column_lo    <= x_lo;
            column_hi    <= x_hi;
            third_column <= x_seam;
            row_lo       <= y_lo;
            row_hi       <= y_hi;
            third_row    <= y_seam;
        end
    end

    assign wanted  = (~column[1] | third_column) & (~row[1] | third_row);
    assign entry_x = column[1] ? map_width : column[0] ? column_lo : column_hi;
    assign entry_y = row[1] ? map_height : row[0] ? row_lo : row_hi;
endmodule

`default_nettype wire
