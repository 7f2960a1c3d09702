`default_nettype none

// One axis of a texel read: the texel that U lies in, floor(U), and its two neighbours, brought
// onto the map. One stage. U lies within one period of a periodic map; otherwise it is clamped, and
// a texel at the border is its own neighbour.
module bump_place #(
    parameter integer UV_WIDTH = 23,
    parameter integer UV_FRAC  = 8
) (
    input  wire                       clk,
    input  wire                       load,
    input  wire        [14:0]         size,      // of the map, texels
    input  wire                       wrap,
    input  wire signed [UV_WIDTH-1:0] u,
    output reg         [13:0]         at,
    output reg         [13:0]         lower,
    output reg         [13:0]         upper,
    output reg                        at_border  // a neighbour is missing
);
    // Wide enough for either end of U's range, and for twice a map's size.
    localparam integer XW = ((UV_WIDTH - UV_FRAC > 15) ? UV_WIDTH - UV_FRAC : 15) + 3;
    localparam integer MW = (UV_WIDTH > XW) ? UV_WIDTH : XW;

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

    wire signed [MW-1:0] place = MW'(u) >>> UV_FRAC;
    wire        [13:0]   here  = coordinate(place[XW-1:0], size, wrap);
    wire signed [XW-1:0] wide  = $signed(XW'(here));
    wire                 unused_top = &{1'b0, place};    // the texel has fewer bits than U

    always_ff @(posedge clk) begin
        if (load) begin
            at        <= here;
            lower     <= coordinate(wide - 1, size, wrap);
            upper     <= coordinate(wide + 1, size, wrap);
            at_border <= ~wrap & ((here == 14'd0) | (15'(here) + 15'd1 == size));
        end
    end
endmodule

`default_nettype wire
