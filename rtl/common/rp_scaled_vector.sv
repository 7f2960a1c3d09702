`default_nettype none

// A vector of any length on its way into a normalisation: shifted, up or down and rounded half up,
// until its longest component has OW - 1 bits with its sign, so that it is as precise at every
// length. Bit for bit the datapath's Fixed::scaled. Rounding may need the last bit.
//
// Stage 0: the length. Stage 1: the shift.
module rp_scaled_vector #(
    parameter integer W  = 38,  // bits of a component, at most 62
    parameter integer OW = 19   // of a shifted one
) (
    input  wire            clk,
    input  wire [1:0]      load,
    input  wire [3*W-1:0]  v,       // x in the low bits
    output reg  [3*OW-1:0] scaled   // likewise
);
    // rp_scaled_cast wants as many bits as it shifts by.
    localparam integer XW = (W > OW) ? W : OW;

    // The bits of the longest component without its sign: -2^k counts as k bits.
    function automatic [5:0] length(input [3*W-1:0] of);
        integer k;
        length = 6'd0;
        for (k = 0; k < W; k = k + 1)
            if ((of[k] ^ of[W-1]) | (of[W+k] ^ of[2*W-1]) | (of[2*W+k] ^ of[3*W-1]))
                length = 6'(k + 1);
    endfunction

    reg  [3*W-1:0]  whole;
    reg  [5:0]      bits;
    wire [3*OW-1:0] shifted;

    genvar k;
    generate
        for (k = 0; k < 3; k = k + 1) begin : g_component
            wire signed [W-1:0] component = whole[k*W +: W];

            rp_scaled_cast #(.W(XW), .LEAST(0), .MOST(W), .OFFSET(2 - OW), .OW(OW)) shift (
                .x(XW'(component)), .exponent(bits), .y(shifted[k*OW +: OW])
            );
        end
    endgenerate

    always_ff @(posedge clk) begin
        if (load[0]) begin
            whole <= v;
            bits  <= length(v);
        end
        if (load[1]) scaled <= shifted;
    end
endmodule

`default_nettype wire
