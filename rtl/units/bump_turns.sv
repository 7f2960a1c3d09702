`default_nettype none

// Kind 2 of bump (Kugler 1998): D = (sin a, cos a sin b, cos a cos b), which is N turned about B by
// a, towards T, and then about T by b, towards B.
//
// Stages 0 to 2: sines and cosines. Stage 3: products. Stage 4: their casts.
module bump_turns #(
    parameter integer AW         = 16,  // bits of an angle
    parameter integer AFRAC      = 15,  // of which fraction bits, in half turns
    parameter integer INDEX_BITS = 6,   // log2 of the sine table's pieces
    parameter integer NW         = 16,  // bits of a sine
    parameter integer NFRAC      = 14,  // of which fraction bits
    parameter integer DW         = 16   // of a component of D, >= NW
) (
    input  wire                 clk,
    input  wire [4:0]           load,
    input  wire signed [AW-1:0] about_b,
    input  wire signed [AW-1:0] about_t,
    output wire [3*DW-1:0]      d
);
    wire signed [NW-1:0]   sin_a, cos_a, sin_b, cos_b;
    reg  signed [NW-1:0]   sin_3, sin_4;
    reg  signed [2*NW-1:0] product_y, product_z;
    reg  signed [NW-1:0]   y, z;
    wire signed [NW-1:0]   fitted_y, fitted_z;

    bump_sine #(
        .AW(AW), .AFRAC(AFRAC), .INDEX_BITS(INDEX_BITS), .COSINE(0), .OW(NW), .OFRAC(NFRAC)
    ) sine_a (.clk(clk), .load(load[2:0]), .angle(about_b), .value(sin_a));
    bump_sine #(
        .AW(AW), .AFRAC(AFRAC), .INDEX_BITS(INDEX_BITS), .COSINE(1), .OW(NW), .OFRAC(NFRAC)
    ) cosine_a (.clk(clk), .load(load[2:0]), .angle(about_b), .value(cos_a));
    bump_sine #(
        .AW(AW), .AFRAC(AFRAC), .INDEX_BITS(INDEX_BITS), .COSINE(0), .OW(NW), .OFRAC(NFRAC)
    ) sine_b (.clk(clk), .load(load[2:0]), .angle(about_t), .value(sin_b));
    bump_sine #(
        .AW(AW), .AFRAC(AFRAC), .INDEX_BITS(INDEX_BITS), .COSINE(1), .OW(NW), .OFRAC(NFRAC)
    ) cosine_b (.clk(clk), .load(load[2:0]), .angle(about_t), .value(cos_b));

    rp_cast #(.W(2 * NW), .SHIFT(NFRAC), .OW(NW)) cast_y (.x(product_y), .y(fitted_y));
    rp_cast #(.W(2 * NW), .SHIFT(NFRAC), .OW(NW)) cast_z (.x(product_z), .y(fitted_z));

    always_ff @(posedge clk) begin
        if (load[3]) begin
            sin_3     <= sin_a;
            product_y <= (2*NW)'(cos_a) * (2*NW)'(sin_b);
            product_z <= (2*NW)'(cos_a) * (2*NW)'(cos_b);
        end
        if (load[4]) begin
            sin_4 <= sin_3;
            y     <= fitted_y;
            z     <= fitted_z;
        end
    end

    assign d[0*DW +: DW] = DW'(sin_4);
    assign d[1*DW +: DW] = DW'(y);
    assign d[2*DW +: DW] = DW'(z);
endmodule

`default_nettype wire
