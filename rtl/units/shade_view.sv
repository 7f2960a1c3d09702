`default_nettype none

// The view vector of `shade`: (eye - P') / |eye - P'|, rounded half up; zero at the eye. Stage 0
// subtracts, exactly. Stages 1 and 2 shift the difference, up or down, until its longest component
// has VW - 2 bits, so that the vector is as precise at every distance. The rest is rp_normalise.
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
    // A difference has a bit more than a position; rp_scaled_cast wants as many as it shifts by.
    localparam integer DW = (PW + 1 > VW) ? PW + 1 : VW;

    function automatic signed [DW-1:0] difference(input signed [PW-1:0] a,
                                                  input signed [PW-1:0] b);
        difference = DW'(a) - DW'(b);
    endfunction

    // The bits of the longest component without its sign. -2^k counts as k bits, and stays in the
    // range of the shifted vector.
    function automatic [DW-1:0] magnitude(input signed [DW-1:0] v);
        magnitude = v[DW-1] ? ~v : v;
    endfunction

    function automatic [5:0] length(input [DW-1:0] bits);
        integer k;
        length = 6'd0;
        for (k = 0; k < DW; k = k + 1) if (bits[k]) length = 6'(k + 1);
    endfunction

    reg signed [DW-1:0] x0, y0, z0, x1, y1, z1;
    reg        [5:0]    length1;
    wire signed [VW-1:0] scaled_x, scaled_y, scaled_z;
    reg  signed [VW-1:0] x2, y2, z2;

    rp_scaled_cast #(.W(DW), .LEAST(0), .MOST(PW), .OFFSET(2 - VW), .OW(VW)) scale_x (
        .x(x1), .exponent(length1), .y(scaled_x)
    );
    rp_scaled_cast #(.W(DW), .LEAST(0), .MOST(PW), .OFFSET(2 - VW), .OW(VW)) scale_y (
        .x(y1), .exponent(length1), .y(scaled_y)
    );
    rp_scaled_cast #(.W(DW), .LEAST(0), .MOST(PW), .OFFSET(2 - VW), .OW(VW)) scale_z (
        .x(z1), .exponent(length1), .y(scaled_z)
    );

    always_ff @(posedge clk) begin
        if (load[0]) begin
            x0 <= difference($signed(eye[0*PW +: PW]), $signed(place[0*PW +: PW]));
            y0 <= difference($signed(eye[1*PW +: PW]), $signed(place[1*PW +: PW]));
            z0 <= difference($signed(eye[2*PW +: PW]), $signed(place[2*PW +: PW]));
        end
        if (load[1]) begin
            length1 <= length(magnitude(x0) | magnitude(y0) | magnitude(z0));
            x1      <= x0;
            y1      <= y0;
            z1      <= z0;
        end
        if (load[2]) begin
            x2 <= scaled_x;
            y2 <= scaled_y;
            z2 <= scaled_z;
        end
    end

    rp_normalise #(
        .W(VW), .OW(NW), .FRAC(NF), .KIND(KIND), .INDEX_BITS(INDEX_BITS),
        .NEWTON_STEPS(NEWTON_STEPS), .BITS(BITS), .L(L)
    ) unit (
        .clk(clk), .load(load[L+2:3]), .x(x2), .y(y2), .z(z2),
        .unit_x(view[0*NW +: NW]), .unit_y(view[1*NW +: NW]), .unit_z(view[2*NW +: NW])
    );
endmodule

`default_nettype wire
