`default_nettype none

// The view vector of `shade`: (eye - P') / |eye - P'|, rounded half up; zero at the eye. Stage 0
// subtracts, exactly; stages 1 and 2 are rp_scaled_vector, the rest is rp_normalise.
module shade_view #(
    parameter integer PW           = 32,  // bits of a position, at most 32
    parameter integer VW           = 19,  // of a vector to be normalised
    parameter integer NW           = 16,  // of a unit vector's component
    parameter integer NF           = 14,  // of which fraction bits
    parameter integer KIND         = 0,   // as in rp_normalise, like the next three
    parameter integer INDEX_BITS   = 7,
    parameter integer NEWTON_STEPS = 2,
    parameter integer BITS         = 24,
    parameter integer L            = 16   // stages of rp_normalise
) (
    input  wire            clk,
    input  wire [L+2:0]    load,
    input  wire [3*PW-1:0] eye,    // x in the low bits, as in all vectors here
    input  wire [3*PW-1:0] place,  // P', with load[0]
    output wire [3*NW-1:0] view    // behind stage L + 2
);
    // A difference has a bit more than a position.
    localparam integer DW = PW + 1;

    reg  [3*DW-1:0] difference;
    wire [3*VW-1:0] scaled;

    genvar k;
    generate
        for (k = 0; k < 3; k = k + 1) begin : g_component
            wire signed [PW-1:0] from = place[k*PW +: PW];
            wire signed [PW-1:0] to   = eye[k*PW +: PW];

            always_ff @(posedge clk) begin
                if (load[0]) difference[k*DW +: DW] <= DW'(to) - DW'(from);
            end
        end
    endgenerate

    rp_scaled_vector #(.W(DW), .OW(VW)) scale (
        .clk(clk), .load(load[2:1]), .v(difference), .scaled(scaled)
    );

    rp_normalise #(
        .W(VW), .OW(NW), .FRAC(NF), .KIND(KIND), .INDEX_BITS(INDEX_BITS),
        .NEWTON_STEPS(NEWTON_STEPS), .BITS(BITS), .L(L)
    ) unit (
        .clk(clk), .load(load[L+2:3]),
        .x(scaled[0*VW +: VW]), .y(scaled[1*VW +: VW]), .z(scaled[2*VW +: VW]),
        .unit_x(view[0*NW +: NW]), .unit_y(view[1*NW +: NW]), .unit_z(view[2*NW +: NW])
    );
endmodule

`default_nettype wire
