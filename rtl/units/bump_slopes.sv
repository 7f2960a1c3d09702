`default_nettype none

// Kind 1 of bump (Blinn 1978): D = (-s_u, -s_v, 1) of the slopes, central differences of the four
// heights around a texel: before and behind along u, then along v. Beside a border there is one
// texel between them instead of two, so that rise counts twice.
//
// Stage 0: the rises, answer by answer. Stage 1: times the scale's mantissa. Stage 2: shifted,
// rounded half up, saturated.
module bump_slopes #(
    parameter integer HW   = 16,  // bits of a height
    parameter integer FRAC = 14,  // fraction bits of a slope
    parameter integer SW   = 20,  // bits of a slope
    parameter integer DW   = 21   // of a component of D, > SW and > FRAC + 1
) (
    input  wire            clk,
    input  wire [2:0]      load,
    input  wire            load_beat,   // an answer is taken
    input  wire [1:0]      j,           // its number
    input  wire            at_side,     // the texel is beside a border along u
    input  wire            at_end,      // along v
    input  wire [HW-1:0]   height,
    input  wire [24:0]     u_mantissa,
    input  wire [5:0]      u_exponent,
    input  wire [24:0]     v_mantissa,
    input  wire [5:0]      v_exponent,
    output wire [3*DW-1:0] d
);
    localparam integer RW = HW + 2;                // a difference, doubled
    localparam integer PW = RW + 26;               // the mantissa becomes signed

    wire signed [RW-1:0] wide = $signed(RW'(height));
    reg  signed [RW-1:0] rise_u, rise_v;
    reg                  twice_u, twice_v;
    reg  signed [PW-1:0] product_u, product_v;
    reg  signed [SW-1:0] slope_u, slope_v;
    wire signed [SW-1:0] fitted_u, fitted_v;
    wire                 unused_load = load[0];    // stage 0 takes every answer

    function automatic signed [PW-1:0] scaled(
        input signed [RW-1:0] rise,
        input                 twice,
        input        [24:0]   mantissa
    );
        scaled = (twice ? PW'(rise) <<< 1 : PW'(rise)) * $signed(PW'(mantissa));
    endfunction

    rp_scaled_cast #(.W(PW), .LEAST(0), .MOST(63), .OFFSET(-FRAC), .OW(SW)) fit_u (
        .x(product_u), .exponent(u_exponent), .y(fitted_u)
    );
    rp_scaled_cast #(.W(PW), .LEAST(0), .MOST(63), .OFFSET(-FRAC), .OW(SW)) fit_v (
        .x(product_v), .exponent(v_exponent), .y(fitted_v)
    );

    always_ff @(posedge clk) begin
        if (load_beat) begin
            if (~j[1]) rise_u <= j[0] ? rise_u + wide : -wide;
            if (j[1])  rise_v <= j[0] ? rise_v + wide : -wide;
            twice_u <= at_side;
            twice_v <= at_end;
        end
        if (load[1]) begin
            product_u <= scaled(rise_u, twice_u, u_mantissa);
            product_v <= scaled(rise_v, twice_v, v_mantissa);
        end
        if (load[2]) begin
            slope_u <= fitted_u;
            slope_v <= fitted_v;
        end
    end

    assign d[0*DW +: DW] = DW'(0) - DW'(slope_u);
    assign d[1*DW +: DW] = DW'(0) - DW'(slope_v);
    assign d[2*DW +: DW] = DW'(1) << FRAC;
endmodule

`default_nettype wire
