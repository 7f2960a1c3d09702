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

    wire signed [MW-1:0] place = MW'(u) >>> UV_FRAC;
    wire        [13:0]   here, at_lower, at_upper;
    wire signed [XW-1:0] wide  = $signed(XW'(here));
    wire                 unused_top = &{1'b0, place};    // the texel has fewer bits than U

    rp_map_coordinate #(.W(XW)) texel (
        .index(place[XW-1:0]), .size(size), .wrap(wrap), .at(here)
    );
    rp_map_coordinate #(.W(XW)) below (
        .index(wide - XW'(1)), .size(size), .wrap(wrap), .at(at_lower)
    );
    rp_map_coordinate #(.W(XW)) above (
        .index(wide + XW'(1)), .size(size), .wrap(wrap), .at(at_upper)
    );

    always_ff @(posedge clk) begin
        if (load) begin
            at        <= here;
            lower     <= at_lower;
            upper     <= at_upper;
            at_border <= ~wrap & ((here == 14'd0) | (15'(here) + 15'd1 == size));
        end
    end
endmodule

`default_nettype wire
