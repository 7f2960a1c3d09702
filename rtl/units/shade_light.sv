`default_nettype none

// One light of `shade`: stages 0 and 1 its cosines with N and V, 2 the side of a two-sided surface,
// 3 the reflection, 4 to 10 the power, 11 its part of the three components of the colour.
module shade_light #(
    parameter integer NW       = 16,  // bits of a unit vector's component
    parameter integer NF       = 14,  // of which fraction bits
    parameter integer CW       = 18,  // of a cosine
    parameter integer CF       = 16,
    parameter integer LW       = 12,  // of a light's colours
    parameter integer LOG_BITS = 5,
    parameter integer EXP_BITS = 6,
    parameter integer TW       = LW + CW + 2  // of its part
) (
    input  wire                 clk,
    input  wire [11:0]          load,
    input  wire [7:0]           shininess,  // registers of the unit
    input  wire [3*NW-1:0]      direction,  // x in the low bits, as in all vectors here
    input  wire [3*LW-1:0]      diffuse,    // red in the low bits
    input  wire [3*LW-1:0]      specular,
    input  wire [3*NW-1:0]      normal,     // with load[0]
    input  wire [3*NW-1:0]      view,
    input  wire                 turned,     // with load[2]: the surface is seen from the back
    input  wire signed [CW-1:0] a,          // with load[3]: N.V, corrected
    output wire [3*TW-1:0]      part        // behind stage 11
);
    // Stages 0 and 1.
    wire signed [CW-1:0] b1, c1;

    shade_dot #(.NW(NW), .NF(NF), .CW(CW), .CF(CF)) with_normal (
        .clk(clk), .load(load[1:0]), .a(normal), .b(direction), .cosine(b1)
    );
    shade_dot #(.NW(NW), .NF(NF), .CW(CW), .CF(CF)) with_view (
        .clk(clk), .load(load[1:0]), .a(direction), .b(view), .cosine(c1)
    );

    // Stage 2. The negative of the least cosine needs a bit more.
    wire signed [CW:0]   lies = (CW+1)'(b1);
    reg  signed [CW:0]   b2;
    reg  signed [CW-1:0] c2;

    always_ff @(posedge clk) begin
        if (load[2]) begin
            b2 <= turned ? -lies : lies;
            c2 <= c1;
        end
    end

    // Stage 3: R.V = 2 a b - c; a light behind the surface gives neither kind of light.
    localparam integer RW = 2 * CW + 4;
    wire signed [RW-1:0] mirrored = ((RW'(a) * RW'(b2)) <<< 1) - (RW'(c2) <<< CF);
    wire signed [CW-1:0] rounded;
    wire                 lit      = (b2 > 0);
    reg  signed [CW-1:0] r3;
    reg  [CW-1:0]        lit3;

    rp_cast #(.W(RW), .SHIFT(CF), .OW(CW)) to_cosine (.x(mirrored), .y(rounded));

    always_ff @(posedge clk) begin
        if (load[3]) begin
            r3   <= lit ? rounded : '0;
            lit3 <= lit ? b2[CW-1:0] : '0;
        end
    end

    // Stages 4 to 10.
    wire signed [CW-1:0] gleam;
    wire [CW-1:0]        lit10;

    shade_power #(.CW(CW), .CF(CF), .LOG_BITS(LOG_BITS), .EXP_BITS(EXP_BITS)) raised (
        .clk(clk), .load(load[10:4]), .n(shininess), .x(r3), .power(gleam)
    );
    rp_delay #(.W(CW), .L(7)) delay (
        .clk(clk), .load(load[10:4]), .in_data(lit3), .out_data(lit10)
    );

    // Stage 11. Neither factor is negative.
    wire [CW-1:0]   shine = gleam;
    reg  [3*TW-1:0] sums;
    integer         m;

    always_ff @(posedge clk)
        if (load[11])
            for (m = 0; m < 3; m = m + 1)
                sums[m*TW +: TW] <= TW'(diffuse[m*LW +: LW]) * TW'(lit10)
                                  + TW'(specular[m*LW +: LW]) * TW'(shine);

    assign part = sums;
endmodule

`default_nettype wire
