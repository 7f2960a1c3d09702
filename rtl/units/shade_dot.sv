`default_nettype none

// The dot product of two vectors of unit length as a cosine: stage 0 multiplies, stage 1 adds and
// rounds. Vectors that are longer saturate.
module shade_dot #(
    parameter integer NW = 16,  // bits of a component
    parameter integer NF = 14,  // of which fraction bits
    parameter integer CW = 18,  // bits of a cosine
    parameter integer CF = 16   // of which fraction bits
) (
    input  wire                   clk,
    input  wire [1:0]             load,
    input  wire signed [3*NW-1:0] a,       // x in the low bits
    input  wire signed [3*NW-1:0] b,
    output wire signed [CW-1:0]   cosine
);
    localparam integer PW = 2 * NW;

    wire signed [NW-1:0] ax = a[0 +: NW], ay = a[NW +: NW], az = a[2*NW +: NW];
    wire signed [NW-1:0] bx = b[0 +: NW], by = b[NW +: NW], bz = b[2*NW +: NW];
    reg  signed [PW-1:0] x, y, z;
    wire signed [PW+1:0] sum = (PW+2)'(x) + (PW+2)'(y) + (PW+2)'(z);
    wire signed [CW-1:0] rounded;
    reg  signed [CW-1:0] result;

    rp_cast #(.W(PW + 2), .SHIFT(2 * NF - CF), .OW(CW)) to_cosine (.x(sum), .y(rounded));

    always_ff @(posedge clk) begin
        if (load[0]) begin
            x <= PW'(ax) * PW'(bx);
            y <= PW'(ay) * PW'(by);
            z <= PW'(az) * PW'(bz);
        end
        if (load[1]) result <= rounded;
    end

    assign cosine = result;
endmodule

`default_nettype wire
