`default_nettype none

// The rotation of bump: v = T Dx + B Dy + N Dz with B = N x T or its opposite, brought to the
// format of vectors on their way into a normalisation. Where B is zero there is no frame: v is N.
//
// Stage 0: the products of B. Stage 1: B. Stage 2: the products of v. Stage 3: their sums, cast;
// with SCALED not cast but, in stages 4 and 5, shifted to their longest component's length.
module bump_rotate #(
    parameter integer NW     = 16,  // bits of a component of N and T
    parameter integer NFRAC  = 14,  // of which fraction bits
    parameter integer DW     = 13,  // bits of a component of D, > DFRAC + 1
    parameter integer DFRAC  = 11,
    parameter integer VW     = 19,  // bits of a component of v
    parameter integer VFRAC  = 16,
    parameter integer SCALED = 0,
    parameter integer L      = 4    // stages: 4, or 6 with SCALED
) (
    input  wire            clk,
    input  wire [L-1:0]    load,
    input  wire [3*NW-1:0] t,           // x in the low bits, as in all vectors here
    input  wire [3*NW-1:0] n,
    input  wire            handedness,  // set: B = -(N x T)
    input  wire [3*DW-1:0] d,
    output wire [3*VW-1:0] v            // behind the last stage
);
    localparam integer CW = 2 * NW + 1;            // a component of N x T
    localparam integer TW = NW + DW;               // a product of v
    localparam integer SW = TW + 2;                // three of them

    initial if (L != ((SCALED != 0) ? 6 : 4)) $fatal(1, "bump_rotate: L does not fit SCALED");

    wire [3*NW-1:0] b, t2, n2;                     // behind stage 1
    wire [3*DW-1:0] d2;
    reg             left;
    wire            frame = |b;

    rp_delay #(.W(6 * NW + 3 * DW), .L(2)) waiting (
        .clk(clk), .load(load[1:0]), .in_data({t, n, d}), .out_data({t2, n2, d2})
    );

    always_ff @(posedge clk) if (load[0]) left <= handedness;

    wire [3*SW-1:0] sums;

    genvar k;
    generate
        for (k = 0; k < 3; k = k + 1) begin : g_component
            localparam integer K1 = (k + 1) % 3;
            localparam integer K2 = (k + 2) % 3;

            wire signed [NW-1:0] n_1 = n[K1*NW +: NW];
            wire signed [NW-1:0] n_2 = n[K2*NW +: NW];
            wire signed [NW-1:0] t_1 = t[K1*NW +: NW];
            wire signed [NW-1:0] t_2 = t[K2*NW +: NW];
            reg  signed [CW-1:0] first, second;
            wire signed [CW-1:0] difference = left ? second - first : first - second;
            wire signed [NW-1:0] fitted;
            reg  signed [NW-1:0] component;

            rp_cast #(.W(CW), .SHIFT(NFRAC), .OW(NW)) cast_b (.x(difference), .y(fitted));

            wire signed [NW-1:0] of_t = t2[k*NW +: NW];
            wire signed [NW-1:0] of_n = n2[k*NW +: NW];
            wire signed [DW-1:0] d_x = frame ? $signed(d2[0*DW +: DW]) : DW'(0);
            wire signed [DW-1:0] d_y = frame ? $signed(d2[1*DW +: DW]) : DW'(0);
            wire signed [DW-1:0] d_z = frame ? $signed(d2[2*DW +: DW]) : DW'(1) <<< DFRAC;
            reg  signed [TW-1:0] along_t, along_b, along_n;

            always_ff @(posedge clk) begin
                if (load[0]) begin
                    first  <= CW'(n_1) * CW'(t_2);
                    second <= CW'(n_2) * CW'(t_1);
                end
                if (load[1]) component <= fitted;
                if (load[2]) begin
                    along_t <= TW'(of_t) * TW'(d_x);
                    along_b <= TW'(component) * TW'(d_y);
                    along_n <= TW'(of_n) * TW'(d_z);
                end
            end

            assign b[k*NW +: NW]    = component;
            assign sums[k*SW +: SW] = SW'(along_t) + SW'(along_b) + SW'(along_n);
        end
        if (SCALED != 0) begin : g_scaled
            reg [3*SW-1:0] whole;

            always_ff @(posedge clk) if (load[3]) whole <= sums;

            rp_scaled_vector #(.W(SW), .OW(VW)) scale (
                .clk(clk), .load(load[5:4]), .v(whole), .scaled(v)
            );
        end else begin : g_cast
            reg  [3*VW-1:0] result;
            wire [3*VW-1:0] limited;

            for (k = 0; k < 3; k = k + 1) begin : g_limit
                rp_cast #(.W(SW), .SHIFT(NFRAC + DFRAC - VFRAC), .OW(VW)) cast (
                    .x($signed(sums[k*SW +: SW])), .y(limited[k*VW +: VW])
                );
            end

            always_ff @(posedge clk) if (load[3]) result <= limited;

            assign v = result;
        end
    endgenerate
endmodule

`default_nettype wire
