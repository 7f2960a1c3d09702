`default_nettype none

// One axis of a height read: the two ends of what is read, then their texel coordinates, brought
// onto the map and to its filter level.
//
// Texel centres lie at +1/2, so between them the cell is found half a texel lower; the nearest
// texel is floor(U). Of a filter level, the ends are those of U +- reach. Stage 1: ends and weight.
// Stage 2: coordinates, with U within one period of a periodic map, or clamped to the border; then
// dropping `level` bits. Where both ends of a footprint have the same, one is read.
module displace_cell #(
    parameter integer UV_WIDTH = 23,
    parameter integer UV_FRAC  = 8
) (
    input  wire                       clk,
    input  wire                       load,        // enable of stage 1
    input  wire                       load_item,   // enable of stage 2
    input  wire        [14:0]         size,        // of the map, texels
    input  wire                       wrap,
    input  wire        [1:0]          filter,
    input  wire signed [UV_WIDTH-1:0] u,
    input  wire signed [UV_WIDTH-1:0] reach,
    input  wire        [3:0]          level,       // with stage 2; 0 without filter levels
    output wire                       two,         // with stage 2: coordinates to read
    output reg                        apart,       // the same behind it
    output reg         [13:0]         low,         // coordinates of the ends' texels
    output reg         [13:0]         high,
    output reg         [UV_FRAC:0]    low_weight,  // 2^UV_FRAC together if both are read
    output reg         [UV_FRAC:0]    high_weight
);
    // Wide enough for a texel beyond either end of U's range, and for twice a map's size.
    localparam integer XW = ((UV_WIDTH - UV_FRAC > 15) ? UV_WIDTH - UV_FRAC : 15) + 3;

    localparam integer MW = (UV_WIDTH + 1 > XW) ? UV_WIDTH + 1 : XW;

    localparam [UV_FRAC:0] ONE = (UV_FRAC+1)'(1) << UV_FRAC;

    wire                 bilinear = (filter == 2'd1);
    wire                 average  = (filter == 2'd3);
    wire                 levels   = filter[1];
    wire signed [MW-1:0] wide     = MW'(u);
    wire signed [MW-1:0] half     = MW'($signed({1'b0, ONE >> 1}));
    wire signed [MW-1:0] to_end   = MW'(reach);
    wire signed [MW-1:0] moved    = levels ? wide - to_end : bilinear ? wide - half : wide;
    wire signed [MW-1:0] other    = wide + to_end;
    wire signed [MW-1:0] first    = moved >>> UV_FRAC;
    wire signed [MW-1:0] last     = levels ? (other >>> UV_FRAC) : first + MW'(1);

    wire unused_top = &{1'b0, first, last};  // coordinates have fewer bits than U

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

    reg signed [XW-1:0] first_index, last_index;
    reg [UV_FRAC:0]     weight;            // of the high texel; none without interpolation

    wire [13:0] low_texel  = coordinate(first_index, size, wrap) >> level;
    wire [13:0] high_texel = coordinate(last_index, size, wrap) >> level;

    assign two = bilinear | (levels & (low_texel != high_texel));

    always_ff @(posedge clk) begin
        if (load) begin
            first_index <= first[XW-1:0];
            last_index  <= last[XW-1:0];
            weight      <= moved[UV_FRAC:0] & (ONE - 1'b1) & {(UV_FRAC+1){bilinear}};
        end
        if (load_item) begin
            apart       <= two;
            low         <= low_texel;
            high        <= high_texel;
            low_weight  <= (average & two) ? ONE >> 1 : ONE - weight;
            high_weight <= average ? ONE >> 1 : levels ? ONE : weight;
        end
    end
endmodule

`default_nettype wire
