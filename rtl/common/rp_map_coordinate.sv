`default_nettype none

// A texel's index along one axis, brought onto the map: wrapped, if it lies within one period of a
// periodic map, else clamped to the border. Combinational.
module rp_map_coordinate #(
    parameter integer W = 18  // bits of the index; holds twice a map's size
) (
    input  wire signed [W-1:0] index,
    input  wire        [14:0]  size,  // of the map, texels
    input  wire                wrap,
    output wire        [13:0]  at
);
    wire signed [W-1:0] whole  = $signed(W'(size));
    wire signed [W-1:0] raised = (index >= 0) ? index : wrap ? index + whole : '0;
    wire signed [W-1:0] x      = (raised < whole) ? raised : wrap ? raised - whole : whole - 1;
    wire                unused_top = &{1'b0, x};  // a coordinate has fewer bits than an index

    assign at = x[13:0];
endmodule

`default_nettype wire
