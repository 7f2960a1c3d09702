`default_nettype none

// One axis of a box of the Summed Height Test: from centre and half-extent to the two columns (or
// rows) of the summed-area table that bound it.
//
// Two stages, enabled from outside: the corners, in texels; and these clipped or brought into the
// map, and widened to one texel where averages would otherwise divide by nothing.
module height_test_side #(
    parameter integer UV_WIDTH = 23,  // bits of a texture coordinate
    parameter integer UV_FRAC  = 8    // of which fraction
) (
    input  wire                       clk,
    input  wire [1:0]                 load,      // register enables of the two stages

    input  wire [12:0]                size,      // of the map along this axis, 1..4096
    input  wire                       wrap,      // the map is periodic
    input  wire                       sum,       // sums are compared: never widen

    input  wire signed [UV_WIDTH-1:0] centre,    // texels, fixed point
    input  wire        [UV_WIDTH-3:0] half,      // half-extent of the box

    output reg  [12:0]                lo,        // table coordinates, 0..size
    output reg  [12:0]                hi,
    output reg  [12:0]                texels,    // how wide the box is, 0..4096
    output reg                        seam       // it crosses a seam: add the table's last entry
);
    // A corner has one bit more than the centre, less the fraction; and it must hold corner - size
    // and corner + size, -2^13 .. 2^13 + 2^12, whatever the format of U.
    localparam integer SHIFTED = UV_WIDTH + 1 - UV_FRAC;
    localparam integer XW = (SHIFTED > 15) ? SHIFTED + 1 : 16;
    localparam integer UW = (UV_WIDTH + 1 > XW) ? UV_WIDTH + 1 : XW;  // centre +- half
    localparam signed [XW-1:0] ONE = 1;

    // The corners. The shift of a signed number is a floor.
    function automatic signed [XW-1:0] texel(
        input signed [UW-1:0] u
    );
        texel = XW'(u >>> UV_FRAC);
    endfunction

    wire signed [UW-1:0] middle = UW'(centre);
    wire signed [UW-1:0] reach  = $signed(UW'(half));

    reg signed [XW-1:0] corner_lo;
    reg signed [XW-1:0] corner_hi;

    always_ff @(posedge clk) begin
        if (load[0]) begin
            corner_lo <= texel(middle - reach);
            corner_hi <= texel(middle + reach);
        end
    end

    // Into the map.
    function automatic signed [XW-1:0] clip(
        input signed [XW-1:0] x,
        input signed [XW-1:0] most
    );
        clip = x[XW-1] ? '0 : (x > most) ? most : x;
    endfunction

    // The period of the map that x lies in: -1, 0 or 1. The unit is not defined further out.
    function automatic signed [1:0] period(
        input signed [XW-1:0] x,
        input signed [XW-1:0] most
    );
        period = x[XW-1] ? -2'sd1 : (x >= most) ? 2'sd1 : 2'sd0;
    endfunction

    function automatic signed [XW-1:0] reduce(
        input signed [XW-1:0] x,
        input signed [XW-1:0] most
    );
        reduce = x[XW-1] ? x + most : (x >= most) ? x - most : x;
    endfunction

    // The whole stage in one function: {seam, texels, hi, lo}. (A simulator then evaluates it once
    // an item, under the register's enable, and not once a cycle.)
    function automatic [39:0] bounds(
        input signed [XW-1:0] first,
        input signed [XW-1:0] last,
        input signed [XW-1:0] most,
        input                 periodic,
        input                 may_widen
    );
        reg signed [XW-1:0] a;
        reg signed [XW-1:0] b;
        begin
            a = periodic ? first : clip(first, most);
            b = periodic ? last : clip(last, most);
            // No texel: take the next one, or the last one of a clamped map.
            if (may_widen && a == b) begin
                if (!periodic && a == most) a = a - ONE;
                else b = b + ONE;
            end
            bounds[38:26] = 13'(b - a);
            bounds[39]    = periodic && period(a, most) != period(b, most);
            bounds[25:13] = 13'(periodic ? reduce(b, most) : b);
            bounds[12:0]  = 13'(periodic ? reduce(a, most) : a);
        end
    endfunction

    always_ff @(posedge clk) begin
        if (load[1]) begin
            {seam, texels, hi, lo} <=
                bounds(corner_lo, corner_hi, $signed(XW'(size)), wrap, ~sum);
        end
    end
endmodule

`default_nettype wire
