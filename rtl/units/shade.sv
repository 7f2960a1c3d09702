`default_nettype none

// Phong's illumination at a vertex: ambient light, and for each directional light a diffuse part
// and a highlight.
//
// V stages: the view vector (shade_view), during which N waits. Behind them, stages 0 and 1: N.V
// and N.N, and each light's cosines. Stage 2: N.V (2 - N.N), which makes up for the rounded length
// of N, and the side of a two-sided surface. Stages 3 to 11: the lights (shade_light). Stage 12:
// their sum with the ambient light, rounded and saturated.
//
// Time: latency 32 (CORDIC: 3 (NORMAL_FRAC + 5) + 19), one vertex a cycle, in_ready follows
// out_ready.
module shade #(
`include "rtl/units/shade_params.svh"
) (
    input  wire                            clk,
    input  wire                            rst_n,          // synchronous, low

    // Registers, stable while vertices are in the unit. Of vectors, light 0 is in the low bits.
    input  wire signed [POSITION_WIDTH-1:0] eye_x,
    input  wire signed [POSITION_WIDTH-1:0] eye_y,
    input  wire signed [POSITION_WIDTH-1:0] eye_z,
    input  wire [LIGHT_WIDTH-1:0]          ambient_red,
    input  wire [LIGHT_WIDTH-1:0]          ambient_green,
    input  wire [LIGHT_WIDTH-1:0]          ambient_blue,
    input  wire [7:0]                      shininess,      // n, 1 to 255
    input  wire                            two_sided,      // seen from the back, N is turned
    input  wire [LIGHTS*NORMAL_WIDTH-1:0]  light_x,        // towards each light, unit length
    input  wire [LIGHTS*NORMAL_WIDTH-1:0]  light_y,
    input  wire [LIGHTS*NORMAL_WIDTH-1:0]  light_z,
    input  wire [LIGHTS*LIGHT_WIDTH-1:0]   diffuse_red,    // light times material
    input  wire [LIGHTS*LIGHT_WIDTH-1:0]   diffuse_green,
    input  wire [LIGHTS*LIGHT_WIDTH-1:0]   diffuse_blue,
    input  wire [LIGHTS*LIGHT_WIDTH-1:0]   specular_red,
    input  wire [LIGHTS*LIGHT_WIDTH-1:0]   specular_green,
    input  wire [LIGHTS*LIGHT_WIDTH-1:0]   specular_blue,

    input  wire                            in_valid,
    output wire                            in_ready,
    input  wire signed [POSITION_WIDTH-1:0] p_x,           // P'
    input  wire signed [POSITION_WIDTH-1:0] p_y,
    input  wire signed [POSITION_WIDTH-1:0] p_z,
    input  wire signed [NORMAL_WIDTH-1:0]  n_x,            // N or N'
    input  wire signed [NORMAL_WIDTH-1:0]  n_y,
    input  wire signed [NORMAL_WIDTH-1:0]  n_z,

    output wire                            out_valid,
    input  wire                            out_ready,
    output wire [COLOUR_WIDTH-1:0]         red,
    output wire [COLOUR_WIDTH-1:0]         green,
    output wire [COLOUR_WIDTH-1:0]         blue
);
    localparam integer NW = NORMAL_WIDTH;
    localparam integer CW = COSINE_WIDTH;
    localparam integer CF = COSINE_FRAC;
    localparam integer LW = LIGHT_WIDTH;
    localparam integer TW = LW + CW + 2;   // a light's part
    localparam integer SW = TW + 5;        // eight of these, the ambient light, a sign

    // Stages of the normalisation, and of the view vector.
    localparam integer BOUND = (NORMAL_FRAC < 4) ? 4 : (NORMAL_FRAC > 18) ? 18 : NORMAL_FRAC;
    localparam integer L     = (NORMALISE_KIND == 0) ? 16 : 3 * (BOUND + 5) + 3;
    localparam integer V     = L + 3;

    wire [V+12:0] all_load;
    wire [12:0]   load = all_load[V +: 13];
    wire          unused_data;

    rp_pipe #(.W(1), .L(V + 13)) stages (
        .clk      (clk),
        .rst_n    (rst_n),
        .in_valid (in_valid),
        .in_ready (in_ready),
        .in_data  (1'b0),
        .out_valid(out_valid),
        .out_ready(out_ready),
        .out_data (unused_data),
        .load     (all_load)
    );

    wire [3*NW-1:0] normal, view;

    shade_view #(
        .PW(POSITION_WIDTH), .VW(UNNORMALISED_WIDTH), .NW(NW), .NF(NORMAL_FRAC),
        .KIND(NORMALISE_KIND), .INDEX_BITS(INVERSE_SQRT_INDEX_BITS),
        .NEWTON_STEPS(INVERSE_SQRT_NEWTON_STEPS), .BITS(INVERSE_SQRT_BITS), .L(L)
    ) to_the_eye (
        .clk(clk), .load(all_load[V-1:0]), .eye({eye_z, eye_y, eye_x}), .place({p_z, p_y, p_x}),
        .view(view)
    );
    rp_delay #(.W(3 * NW), .L(V)) delay (
        .clk(clk), .load(all_load[V-1:0]), .in_data({n_z, n_y, n_x}), .out_data(normal)
    );

    // Stages 0 and 1.
    wire signed [CW-1:0] a1, q1;

    shade_dot #(.NW(NW), .NF(NORMAL_FRAC), .CW(CW), .CF(CF)) with_view (
        .clk(clk), .load(load[1:0]), .a(normal), .b(view), .cosine(a1)
    );
    shade_dot #(.NW(NW), .NF(NORMAL_FRAC), .CW(CW), .CF(CF)) with_itself (
        .clk(clk), .load(load[1:0]), .a(normal), .b(normal), .cosine(q1)
    );

    // Stage 2.
    localparam integer AW = 2 * CW + 4;
    localparam integer FW = CW + 2;
    localparam signed [FW-1:0] TWO = FW'(1) <<< (CF + 1);

    wire                 turned  = two_sided & a1[CW-1];
    wire signed [CW:0]   seen    = (CW+1)'(a1);
    wire signed [CW:0]   towards = turned ? -seen : seen;
    wire signed [FW-1:0] factor  = TWO - FW'(q1);
    wire signed [AW-1:0] product = AW'(towards) * AW'(factor);
    wire signed [CW-1:0] corrected;
    reg  signed [CW-1:0] a2;

    rp_cast #(.W(AW), .SHIFT(CF), .OW(CW)) to_cosine (.x(product), .y(corrected));

    always_ff @(posedge clk) if (load[2]) a2 <= corrected;

    // Stages 0 to 11 of the lights.
    wire [LIGHTS*3*TW-1:0] parts;

    genvar i;
    generate
        for (i = 0; i < LIGHTS; i = i + 1) begin : g_light
            shade_light #(
                .NW(NW), .NF(NORMAL_FRAC), .CW(CW), .CF(CF), .LW(LW),
                .LOG_BITS(POWER_LOG_INDEX_BITS), .EXP_BITS(POWER_EXP_INDEX_BITS), .TW(TW)
            ) light (
                .clk(clk), .load(load[11:0]), .shininess(shininess),
                .direction({light_z[i*NW +: NW], light_y[i*NW +: NW], light_x[i*NW +: NW]}),
                .diffuse({diffuse_blue[i*LW +: LW], diffuse_green[i*LW +: LW],
                          diffuse_red[i*LW +: LW]}),
                .specular({specular_blue[i*LW +: LW], specular_green[i*LW +: LW],
                           specular_red[i*LW +: LW]}),
                .normal(normal), .view(view), .turned(turned), .a(a2),
                .part(parts[i*3*TW +: 3*TW])
            );
        end
    endgenerate

    // Stage 12. Sums are not negative, so the cast saturates at the largest colour.
    wire [3*LW-1:0] ambient = {ambient_blue, ambient_green, ambient_red};
    reg  [3*SW-1:0] sums;
    integer         k, m;

    always_comb begin
        for (k = 0; k < 3; k = k + 1) begin
            sums[k*SW +: SW] = SW'(ambient[k*LW +: LW]) << CF;
            for (m = 0; m < LIGHTS; m = m + 1)
                sums[k*SW +: SW] = sums[k*SW +: SW] + SW'(parts[(3*m+k)*TW +: TW]);
        end
    end

    wire [3*(COLOUR_WIDTH+1)-1:0] rounded;
    reg  [3*COLOUR_WIDTH-1:0]     colour;
    wire [2:0]                    unused_sign;

    generate
        for (i = 0; i < 3; i = i + 1) begin : g_colour
            rp_cast #(.W(SW), .SHIFT(LIGHT_FRAC + CF - COLOUR_FRAC), .OW(COLOUR_WIDTH + 1)) cast (
                .x(sums[i*SW +: SW]), .y(rounded[i*(COLOUR_WIDTH+1) +: COLOUR_WIDTH+1])
            );
            assign unused_sign[i] = rounded[i*(COLOUR_WIDTH+1) + COLOUR_WIDTH];
            always_ff @(posedge clk)
                if (load[12])
                    colour[i*COLOUR_WIDTH +: COLOUR_WIDTH]
                        <= rounded[i*(COLOUR_WIDTH+1) +: COLOUR_WIDTH];
        end
    endgenerate

    assign {blue, green, red} = colour;
endmodule

`default_nettype wire
