`default_nettype none

// Calculate New U, New P and New N (Doggett and Hirche 2000, sections 2.1, 3.1.2 and 3.1.4): the
// vertex half-way between the ends of an edge. U and P are halves of sums, floored; N and T are
// sums over their length. Everything is symmetric in the two ends.
//
// Stage 1: the sums. The stages after it: two normalisations side by side; U, P and the generation
// wait for them.
//
// Time: latency 17 (CORDIC: 3 (NORMAL_FRAC + 5) + 4), one vertex a cycle, in_ready follows
// out_ready.
module mid_vertex #(
`include "rtl/units/mid_vertex_params.svh"
) (
    input  wire                             clk,
    input  wire                             rst_n,        // synchronous, low

    input  wire                             in_valid,
    output wire                             in_ready,
    input  wire signed [UV_WIDTH-1:0]       u1_x,         // end 1: U
    input  wire signed [UV_WIDTH-1:0]       u1_y,
    input  wire        [3:0]                generation1,  // 0 to 14
    input  wire signed [POSITION_WIDTH-1:0] p1_x,         // P
    input  wire signed [POSITION_WIDTH-1:0] p1_y,
    input  wire signed [POSITION_WIDTH-1:0] p1_z,
    input  wire signed [NORMAL_WIDTH-1:0]   n1_x,         // N
    input  wire signed [NORMAL_WIDTH-1:0]   n1_y,
    input  wire signed [NORMAL_WIDTH-1:0]   n1_z,
    input  wire signed [NORMAL_WIDTH-1:0]   t1_x,         // T
    input  wire signed [NORMAL_WIDTH-1:0]   t1_y,
    input  wire signed [NORMAL_WIDTH-1:0]   t1_z,
    input  wire                             left1,        // the bitangent is -(N x T)
    input  wire signed [UV_WIDTH-1:0]       u2_x,         // end 2
    input  wire signed [UV_WIDTH-1:0]       u2_y,
    input  wire        [3:0]                generation2,
    input  wire signed [POSITION_WIDTH-1:0] p2_x,
    input  wire signed [POSITION_WIDTH-1:0] p2_y,
    input  wire signed [POSITION_WIDTH-1:0] p2_z,
    input  wire signed [NORMAL_WIDTH-1:0]   n2_x,
    input  wire signed [NORMAL_WIDTH-1:0]   n2_y,
    input  wire signed [NORMAL_WIDTH-1:0]   n2_z,
    input  wire signed [NORMAL_WIDTH-1:0]   t2_x,
    input  wire signed [NORMAL_WIDTH-1:0]   t2_y,
    input  wire signed [NORMAL_WIDTH-1:0]   t2_z,
    input  wire                             left2,

    output wire                             out_valid,
    input  wire                             out_ready,
    output wire signed [UV_WIDTH-1:0]       u12_x,        // the midpoint
    output wire signed [UV_WIDTH-1:0]       u12_y,
    output wire        [3:0]                generation12,
    output wire signed [POSITION_WIDTH-1:0] p12_x,
    output wire signed [POSITION_WIDTH-1:0] p12_y,
    output wire signed [POSITION_WIDTH-1:0] p12_z,
    output wire signed [NORMAL_WIDTH-1:0]   n12_x,
    output wire signed [NORMAL_WIDTH-1:0]   n12_y,
    output wire signed [NORMAL_WIDTH-1:0]   n12_z,
    output wire signed [NORMAL_WIDTH-1:0]   t12_x,
    output wire signed [NORMAL_WIDTH-1:0]   t12_y,
    output wire signed [NORMAL_WIDTH-1:0]   t12_z,
    output wire                             left12
);
    localparam integer UW = UV_WIDTH;
    localparam integer PW = POSITION_WIDTH;
    localparam integer NW = NORMAL_WIDTH;
    localparam integer VW = UNNORMALISED_WIDTH;
    localparam integer KEPT = 2 * UW + 3 * PW + 5;  // U, P, generation, left

    localparam integer BOUND = (NORMAL_FRAC < 4) ? 4 : (NORMAL_FRAC > 18) ? 18 : NORMAL_FRAC;
    localparam integer NL    = (NORMALISE_KIND == 0) ? 16 : 3 * (BOUND + 5) + 3;
    localparam integer L     = 1 + NL;

    // One bit more for the sum; dropping the lowest bit floors, whatever the order of the ends.
    function automatic signed [UW-1:0] half_u(input signed [UW-1:0] a, input signed [UW-1:0] b);
        logic signed [UW:0] sum;
        logic               unused_half;
        begin
            sum = (UW+1)'(a) + (UW+1)'(b);
            {half_u, unused_half} = sum;
        end
    endfunction

    function automatic signed [PW-1:0] half_p(input signed [PW-1:0] a, input signed [PW-1:0] b);
        logic signed [PW:0] sum;
        logic               unused_half;
        begin
            sum = (PW+1)'(a) + (PW+1)'(b);
            {half_p, unused_half} = sum;
        end
    endfunction

    wire [3:0]      generation = ((generation1 > generation2) ? generation1 : generation2) + 4'd1;
    wire [KEPT-1:0] halves = {half_u(u1_x, u2_x), half_u(u1_y, u2_y), half_p(p1_x, p2_x),
                              half_p(p1_y, p2_y), half_p(p1_z, p2_z), generation, left1 | left2};
    wire [L-1:0]    load;

    rp_pipe #(.W(KEPT), .L(L)) stages (
        .clk      (clk),
        .rst_n    (rst_n),
        .in_valid (in_valid),
        .in_ready (in_ready),
        .in_data  (halves),
        .out_valid(out_valid),
        .out_ready(out_ready),
        .out_data ({u12_x, u12_y, p12_x, p12_y, p12_z, generation12, left12}),
        .load     (load)
    );

    // N and T: components x, y, z of N, then of T.
    wire [6*NW-1:0] first  = {t1_z, t1_y, t1_x, n1_z, n1_y, n1_x};
    wire [6*NW-1:0] second = {t2_z, t2_y, t2_x, n2_z, n2_y, n2_x};
    wire [6*VW-1:0] fitted;
    reg  [6*VW-1:0] sums;
    wire [6*NW-1:0] units;

    always_ff @(posedge clk) if (load[0]) sums <= fitted;

    genvar k;
    generate
        for (k = 0; k < 6; k = k + 1) begin : g_component
            wire signed [NW-1:0] a = first[k*NW +: NW];
            wire signed [NW-1:0] b = second[k*NW +: NW];

            rp_cast #(.W(NW + 1), .SHIFT(NORMAL_FRAC - UNNORMALISED_FRAC), .OW(VW)) cast (
                .x((NW+1)'(a) + (NW+1)'(b)), .y(fitted[k*VW +: VW])
            );
        end
        for (k = 0; k < 2; k = k + 1) begin : g_vector
            rp_normalise #(
                .W(VW), .OW(NW), .FRAC(NORMAL_FRAC), .KIND(NORMALISE_KIND),
                .INDEX_BITS(INVERSE_SQRT_INDEX_BITS), .NEWTON_STEPS(INVERSE_SQRT_NEWTON_STEPS),
                .BITS(INVERSE_SQRT_BITS), .L(NL)
            ) normalise (
                .clk(clk), .load(load[L-1:1]),
                .x($signed(sums[(3*k)*VW +: VW])), .y($signed(sums[(3*k+1)*VW +: VW])),
                .z($signed(sums[(3*k+2)*VW +: VW])),
                .unit_x(units[(3*k)*NW +: NW]), .unit_y(units[(3*k+1)*NW +: NW]),
                .unit_z(units[(3*k+2)*NW +: NW])
            );
        end
    endgenerate

    assign {t12_z, t12_y, t12_x, n12_z, n12_y, n12_x} = units;
endmodule

`default_nettype wire
