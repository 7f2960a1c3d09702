`default_nettype none

// One axis of a height read: the cell that U lies in and U's place in it, then the two texel
// coordinates of that cell, brought onto the map.
//
// Texel centres lie at +1/2, so between them the cell is found half a texel lower; the nearest
// texel is floor(U). Stage 1: cell and weight. Stage 2: coordinates, with U within one period of a
// periodic map, or clamped to the border.
module displace_cell #(
    parameter integer UV_WIDTH = 23,
    parameter integer UV_FRAC  = 8
) (
    input  wire                       clk,
    input  wire                       load,        // enable of stage 1
    input  wire                       load_item,   // enable of stage 2
    input  wire        [14:0]         size,        // of the map, texels
    input  wire                       wrap,
    input  wire                       bilinear,
    input  wire signed [UV_WIDTH-1:0] u,
    output reg         [13:0]         low,         // coordinates of the cell's texels
    output reg         [13:0]         high,
    output reg         [UV_FRAC:0]    low_weight,  // 2^UV_FRAC together
    output reg         [UV_FRAC:0]    high_weight
);
    // Wide enough for a texel beyond either end of U's range, and for twice a map's size.
    localparam integer XW = ((UV_WIDTH - UV_FRAC > 15) ? UV_WIDTH - UV_FRAC : 15) + 3;

    localparam integer MW = (UV_WIDTH + 1 > XW) ? UV_WIDTH + 1 : XW;

    localparam [UV_FRAC:0] ONE = (UV_FRAC+1)'(1) << UV_FRAC;

    wire signed [MW-1:0] wide  = MW'(u);
    wire signed [MW-1:0] half  = MW'($signed({1'b0, ONE >> 1}));
    wire signed [MW-1:0] moved = bilinear ? wide - half : wide;
    wire signed [MW-1:0] place = moved >>> UV_FRAC;

    wire unused_top = &{1'b0, place};      // the cell has fewer bits than U

    function automatic [13:0] coordinate(
        input signed [XW-1:0] i,
        input        [14:0]   map_size,
        input                 periodic
    );
        logic signed [XW-1:0] whole;
        logic signed [XW-1:0] x;
        begin
            whole = $signed(XW'(map_size));
            if (periodic) begin
                x = (i < 0) ? i + whole : i;
                x = (x >= whole) ? x - whole : x;
            end else begin
                x = (i < 0) ? '0 : i;
                x = (x > whole - 1) ? whole - 1 : x;
            end
            coordinate = x[13:0];
        end
    endfunction

    reg signed [XW-1:0]  index;
    reg        [UV_FRAC:0] weight;         // of the high texel; none without interpolation

    always_ff @(posedge clk) begin
        if (load) begin
            index  <= place[XW-1:0];
            weight <= moved[UV_FRAC:0] & (ONE - 1'b1) & {(UV_FRAC+1){bilinear}};
        end
        if (load_item) begin
            low         <= coordinate(index, size, wrap);
            high        <= coordinate(index + 1, size, wrap);
            low_weight  <= ONE - weight;
            high_weight <= weight;
        end
    end
endmodule

`default_nettype wire
