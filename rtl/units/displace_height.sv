`default_nettype none

// The height at U from the texels read: the sum of texel * weight * weight, then one cast.
//
// Stage 1: times the weight along x. Stage 2: times that along y. Then the beats of a vertex are
// added up in stage 3, exact: HEIGHT_WIDTH + 2 UV_FRAC bits, since weights sum to 2^UV_FRAC; or the
// highest of them is kept, the lowest where the surface is seen from the back. Stage 4: SC_RND and
// SC_SAT to `filtered_height`. A single texel has weight one, and is aligned but not cut.
//
// `load` are the enables of stages 1 and 2, `load_beat` that of stage 3, `load_height` of stage 4.
module displace_height #(
    parameter integer HEIGHT_WIDTH = 16,
    parameter integer UV_FRAC      = 8,
    parameter integer SHIFT        = 8,   // fraction bits dropped by the cast; below 0: gained
    parameter integer FILTERED     = 24,  // bits of a filtered height
    parameter integer OW           = 24   // bits of the result, >= FILTERED
) (
    input  wire                    clk,
    input  wire [1:0]              load,
    input  wire                    load_beat,
    input  wire                    load_height,
    input  wire [1:0]              filter,
    input  wire                    first,      // beat of a vertex, at stage 3
    input  wire                    back,       // likewise
    input  wire [HEIGHT_WIDTH-1:0] texel,
    input  wire [UV_FRAC:0]        weight_x,
    input  wire [UV_FRAC:0]        weight_y,
    output reg  [OW-1:0]           height
);
    localparam integer SW      = HEIGHT_WIDTH + 2 * UV_FRAC + 1;
    localparam integer GAINED  = (SHIFT < 0) ? -SHIFT : 0;
    localparam integer DROPPED = (SHIFT > 0) ? SHIFT : 0;
    localparam integer WIDE    = ((SW + GAINED > OW) ? SW + GAINED : OW) + 1;

    localparam [WIDE-1:0] HALF = (WIDE'(1) << DROPPED) >> 1;
    localparam [WIDE-1:0] HIGH = (WIDE'(1) << FILTERED) - WIDE'(1);

    reg [SW-1:0]    row;
    reg [UV_FRAC:0] row_weight;
    reg [SW-1:0]    term;
    reg [SW-1:0]    sum;

    wire [WIDE-1:0] rounded = ((WIDE'(sum) << GAINED) + HALF) >> DROPPED;
    wire [WIDE-1:0] limited = (filter[0] && rounded > HIGH) ? HIGH : rounded;

    wire            choose  = (filter == 2'd2);
    wire            keep    = back ? (sum < term) : (sum > term);
    wire [SW-1:0]   joined  = ~choose ? sum + term : keep ? sum : term;

    always_ff @(posedge clk) begin
        if (load[0]) begin
            row        <= SW'(texel) * SW'(weight_x);
            row_weight <= weight_y;
        end
        if (load[1]) term <= row * SW'(row_weight);
        if (load_beat) sum <= first ? term : joined;
        if (load_height) height <= limited[OW-1:0];
    end

    wire unused_top = &{1'b0, limited[WIDE-1:OW]};
endmodule

`default_nettype wire
