`default_nettype none

// The bump mapping unit (Doggett and Hirche 2000, section 2.1 and figure 8): the normal of the
// displaced surface. A texel gives a vector D in the map's frame, which is rotated into the
// vertex's: N' = normalise(T Dx + B Dy + N Dz). BUMP_KIND says what a texel is: 0 the stored
// normal; 1 heights, whose differences are slopes (Blinn); 2 two rotation angles (Kugler).
//
// Stage 1: the texel's place. Then the read: one, or four with kind 1, a read a cycle. Behind the
// answers the stages of the kind (0: none, 1: 3, 2: 5), the rotation (4; kind 1: 6), the
// normalisation.
//
// Time, with a memory that answers M cycles after a request: latency 22 + M, kind 1 31 + M, kind 2
// 27 + M (with CORDIC 3 (DISPLACED_NORMAL_FRAC + 5) - 13 more); one vertex in a cycle, kind 1 in
// four; in_ready depends on registers and on the memory alone.
module bump #(
`include "rtl/units/bump_params.svh"
) (
    input  wire                           clk,
    input  wire                           rst_n,             // synchronous, low

    // Registers, stable while vertices are in the unit.
    input  wire        [14:0]             map_width,         // texels
    input  wire        [14:0]             map_height,
    input  wire                           wrap,              // the map is periodic
    input  wire        [24:0]             slope_u_mantissa,  // kind 1: slope = rise over two
    input  wire        [5:0]              slope_u_exponent,  // texels * mantissa * 2^-exponent
    input  wire        [24:0]             slope_v_mantissa,
    input  wire        [5:0]              slope_v_exponent,

    input  wire                           in_valid,
    output wire                           in_ready,
    input  wire signed [UV_WIDTH-1:0]     u_x,               // within one period of the map
    input  wire signed [UV_WIDTH-1:0]     u_y,
    input  wire signed [NORMAL_WIDTH-1:0] n_x,               // N
    input  wire signed [NORMAL_WIDTH-1:0] n_y,
    input  wire signed [NORMAL_WIDTH-1:0] n_z,
    input  wire signed [NORMAL_WIDTH-1:0] t_x,               // T
    input  wire signed [NORMAL_WIDTH-1:0] t_y,
    input  wire signed [NORMAL_WIDTH-1:0] t_z,
    input  wire                           handedness,        // set: B = -(N x T)

    // The texel read port: requests, and answers in their order. An answer is x of a normal in the
    // low bits, y, z; a height; or the angle about B in the low bits, then the one about T.
    output wire                           texel_valid,
    input  wire                           texel_ready,
    output wire        [13:0]             texel_x,
    output wire        [13:0]             texel_y,
    input  wire                           texel_rvalid,
    output wire                           texel_rready,
    input  wire        [((BUMP_KIND == 0) ? 3 * MAP_NORMAL_WIDTH :
                         (BUMP_KIND == 1) ? HEIGHT_WIDTH : 2 * ANGLE_WIDTH)-1:0] texel_rdata,

    output wire                           out_valid,
    input  wire                           out_ready,
    output wire signed [MAP_NORMAL_WIDTH-1:0]       map_normal_x,   // N_D; 0 with kind 1
    output wire signed [MAP_NORMAL_WIDTH-1:0]       map_normal_y,
    output wire signed [MAP_NORMAL_WIDTH-1:0]       map_normal_z,
    output wire signed [DISPLACED_NORMAL_WIDTH-1:0] displaced_normal_x,  // N'
    output wire signed [DISPLACED_NORMAL_WIDTH-1:0] displaced_normal_y,
    output wire signed [DISPLACED_NORMAL_WIDTH-1:0] displaced_normal_z
);
    localparam integer NW = NORMAL_WIDTH;
    localparam integer MW = MAP_NORMAL_WIDTH;
    localparam integer VW = 6 * NW + 1;            // T, N and handedness
    localparam integer XW = (BUMP_KIND == 0) ? 3 * MW
                          : (BUMP_KIND == 1) ? HEIGHT_WIDTH : 2 * ANGLE_WIDTH;

    // D: as wide as what it is made of, and as 1.0 in its format.
    localparam integer DFRAC = (BUMP_KIND == 0) ? MAP_NORMAL_FRAC
                             : (BUMP_KIND == 1) ? SLOPE_FRAC : NORMAL_FRAC;
    localparam integer MADE  = (BUMP_KIND == 0) ? MW
                             : (BUMP_KIND == 1) ? SLOPE_WIDTH + 1 : NW;
    localparam integer DW    = (MADE > DFRAC + 2) ? MADE : DFRAC + 2;

    // Stages: of the kind, of the rotation, of the normalisation.
    localparam integer F  = (BUMP_KIND == 0) ? 0 : (BUMP_KIND == 1) ? 3 : 5;
    localparam integer R  = (BUMP_KIND == 1) ? 6 : 4;
    localparam integer BOUND = (DISPLACED_NORMAL_FRAC < 4) ? 4
                             : (DISPLACED_NORMAL_FRAC > 18) ? 18 : DISPLACED_NORMAL_FRAC;
    localparam integer NL = (NORMALISE_KIND == 0) ? 16 : 3 * (BOUND + 5) + 3;
    localparam integer L  = F + R + NL;

    // Reads in flight: one a cycle while the memory answers within 6 cycles.
    localparam integer IN_FLIGHT = 8;

    // Stage 1.
    wire          load_place;
    wire          place_valid, place_ready;
    wire [VW-1:0] place_vertex;
    wire [13:0]   column, left, right, row, below, above;
    wire          at_side, at_end;

    rp_pipe #(.W(VW), .L(1)) placing (
        .clk(clk), .rst_n(rst_n),
        .in_valid(in_valid), .in_ready(in_ready),
        .in_data({handedness, n_z, n_y, n_x, t_z, t_y, t_x}),
        .out_valid(place_valid), .out_ready(place_ready), .out_data(place_vertex),
        .load(load_place)
    );
    bump_place #(.UV_WIDTH(UV_WIDTH), .UV_FRAC(UV_FRAC)) place_u (
        .clk(clk), .load(load_place), .size(map_width), .wrap(wrap), .u(u_x),
        .at(column), .lower(left), .upper(right), .at_border(at_side)
    );
    bump_place #(.UV_WIDTH(UV_WIDTH), .UV_FRAC(UV_FRAC)) place_v (
        .clk(clk), .load(load_place), .size(map_height), .wrap(wrap), .u(u_y),
        .at(row), .lower(below), .upper(above), .at_border(at_end)
    );

    // The reads. A vertex rides along with each.
    wire          answer_valid, answer_ready, unused_read;
    wire [VW-1:0] answer_vertex;
    wire [XW-1:0] answer;
    wire          made_valid, made_ready;          // answers that complete a vertex
    wire [L-1:0]  load;
    wire [3*DW-1:0] d;                             // behind stage F
    wire [VW-1:0] vertex;                          // likewise

    generate
        if (BUMP_KIND == 1) begin : g_slopes
            localparam integer PLACES = 6 * 14 + 2;

            wire              beat_valid, beat_ready, beat_last, unused_load;
            wire [2:0]        beat_j;
            wire [PLACES-1:0] places;
            wire [13:0]       x_at, x_before, x_behind, y_at, y_before, y_behind;
            wire              side, border;
            wire [VW-1:0]     beat_vertex;
            wire              answer_last, answer_side, answer_end, load_beat;
            wire [1:0]        answer_j;

            rp_expand #(.W(PLACES + VW), .NW(3)) reading (
                .clk(clk), .rst_n(rst_n),
                .in_valid(place_valid), .in_ready(place_ready),
                .in_data({column, left, right, row, below, above, at_side, at_end,
                          place_vertex}),
                .in_n(3'd4),
                .out_valid(beat_valid), .out_ready(beat_ready), .out_data({places, beat_vertex}),
                .out_j(beat_j), .out_last(beat_last), .load(unused_load)
            );
            assign {x_at, x_before, x_behind, y_at, y_before, y_behind, side, border} = places;
            assign texel_x = beat_j[1] ? x_at : beat_j[0] ? x_behind : x_before;
            assign texel_y = beat_j[1] ? (beat_j[0] ? y_behind : y_before) : y_at;

            wire unused_j = &{1'b0, beat_j[2]};    // four beats are numbered 0 to 3

            rp_client #(.DW(XW), .TW(5 + VW), .K(IN_FLIGHT)) reader (
                .clk(clk), .rst_n(rst_n),
                .in_valid(beat_valid), .in_ready(beat_ready), .in_read(1'b1),
                .in_tag({beat_j[1:0], beat_last, side, border, beat_vertex}),
                .mem_valid(texel_valid), .mem_ready(texel_ready),
                .mem_rvalid(texel_rvalid), .mem_rready(texel_rready), .mem_rdata(texel_rdata),
                .out_valid(answer_valid), .out_ready(answer_ready),
                .out_tag({answer_j, answer_last, answer_side, answer_end, answer_vertex}),
                .out_read(unused_read), .out_data(answer)
            );
            rp_collect differencing (
                .in_valid(answer_valid), .in_ready(answer_ready), .in_last(answer_last),
                .out_valid(made_valid), .out_ready(made_ready), .load(load_beat)
            );
            bump_slopes #(
                .HW(HEIGHT_WIDTH), .FRAC(SLOPE_FRAC), .SW(SLOPE_WIDTH), .DW(DW)
            ) slopes (
                .clk(clk), .load(load[2:0]), .load_beat(load_beat), .j(answer_j),
                .at_side(answer_side), .at_end(answer_end), .height(answer),
                .u_mantissa(slope_u_mantissa), .u_exponent(slope_u_exponent),
                .v_mantissa(slope_v_mantissa), .v_exponent(slope_v_exponent), .d(d)
            );
        end else begin : g_one_read
            assign texel_x = column;
            assign texel_y = row;

            wire unused_places = &{1'b0, left, right, below, above, at_side, at_end};
            wire unused_slopes = &{1'b0, slope_u_mantissa, slope_u_exponent, slope_v_mantissa,
                                   slope_v_exponent};

            rp_client #(.DW(XW), .TW(VW), .K(IN_FLIGHT)) reader (
                .clk(clk), .rst_n(rst_n),
                .in_valid(place_valid), .in_ready(place_ready), .in_read(1'b1),
                .in_tag(place_vertex),
                .mem_valid(texel_valid), .mem_ready(texel_ready),
                .mem_rvalid(texel_rvalid), .mem_rready(texel_rready), .mem_rdata(texel_rdata),
                .out_valid(answer_valid), .out_ready(answer_ready), .out_tag(answer_vertex),
                .out_read(unused_read), .out_data(answer)
            );
            assign made_valid   = answer_valid;
            assign answer_ready = made_ready;

            if (BUMP_KIND == 0) begin : g_normals
                genvar k;
                for (k = 0; k < 3; k = k + 1) begin : g_component
                    wire signed [MW-1:0] stored = answer[k*MW +: MW];
                    assign d[k*DW +: DW] = DW'(stored);
                end
            end else begin : g_turns
                bump_turns #(
                    .AW(ANGLE_WIDTH), .AFRAC(ANGLE_FRAC), .INDEX_BITS(SINE_INDEX_BITS),
                    .NW(NW), .NFRAC(NORMAL_FRAC), .DW(DW)
                ) turns (
                    .clk(clk), .load(load[4:0]),
                    .about_b(answer[0 +: ANGLE_WIDTH]), .about_t(answer[ANGLE_WIDTH +: ANGLE_WIDTH]),
                    .d(d)
                );
            end
        end
    endgenerate

    wire unused_out;

    rp_pipe #(.W(1), .L(L)) stages (
        .clk(clk), .rst_n(rst_n),
        .in_valid(made_valid), .in_ready(made_ready), .in_data(1'b0),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(unused_out),
        .load(load)
    );

    // The vertex waits for D; N_D, where there is one, for N'.
    wire [3*MW-1:0] map_normal;

    generate
        if (F == 0) begin : g_at_once
            assign vertex = answer_vertex;
        end else begin : g_later
            rp_delay #(.W(VW), .L(F)) waiting (
                .clk(clk), .load(load[F-1:0]), .in_data(answer_vertex), .out_data(vertex)
            );
        end
        if (BUMP_KIND == 1) begin : g_no_map_normal
            assign map_normal = '0;
        end else begin : g_map_normal
            wire [3*MW-1:0] as_map_normal;
            genvar k;
            for (k = 0; k < 3; k = k + 1) begin : g_component
                rp_cast #(.W(DW), .SHIFT(DFRAC - MAP_NORMAL_FRAC), .OW(MW)) cast (
                    .x($signed(d[k*DW +: DW])), .y(as_map_normal[k*MW +: MW])
                );
            end
            rp_delay #(.W(3 * MW), .L(R + NL)) keeping (
                .clk(clk), .load(load[L-1:F]), .in_data(as_map_normal), .out_data(map_normal)
            );
        end
    endgenerate

    assign {map_normal_z, map_normal_y, map_normal_x} = map_normal;

    wire [3*UNNORMALISED_WIDTH-1:0] v;

    bump_rotate #(
        .NW(NW), .NFRAC(NORMAL_FRAC), .DW(DW), .DFRAC(DFRAC), .VW(UNNORMALISED_WIDTH),
        .VFRAC(UNNORMALISED_FRAC), .SCALED((BUMP_KIND == 1) ? 1 : 0), .L(R)
    ) rotation (
        .clk(clk), .load(load[F+R-1:F]), .t(vertex[0 +: 3*NW]), .n(vertex[3*NW +: 3*NW]),
        .handedness(vertex[6*NW]), .d(d), .v(v)
    );
    rp_normalise #(
        .W(UNNORMALISED_WIDTH), .OW(DISPLACED_NORMAL_WIDTH), .FRAC(DISPLACED_NORMAL_FRAC),
        .KIND(NORMALISE_KIND), .INDEX_BITS(INVERSE_SQRT_INDEX_BITS),
        .NEWTON_STEPS(INVERSE_SQRT_NEWTON_STEPS), .BITS(INVERSE_SQRT_BITS), .L(NL)
    ) normalise (
        .clk(clk), .load(load[L-1:F+R]),
        .x($signed(v[0*UNNORMALISED_WIDTH +: UNNORMALISED_WIDTH])),
        .y($signed(v[1*UNNORMALISED_WIDTH +: UNNORMALISED_WIDTH])),
        .z($signed(v[2*UNNORMALISED_WIDTH +: UNNORMALISED_WIDTH])),
        .unit_x(displaced_normal_x), .unit_y(displaced_normal_y), .unit_z(displaced_normal_z)
    );
endmodule

`default_nettype wire
