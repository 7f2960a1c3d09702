`default_nettype none

// One corner of view_clip against the six planes: stage 0 makes its distances from them, stage 1
// compares these with the reach. Exact throughout. A coordinate at an end of its format has been
// saturated: such a corner is beyond nothing.
module view_clip_corner #(
    parameter integer CW = 32,  // bits of eye coordinates
    parameter integer VW = 24,  // bits of sines and cosines
    parameter integer VF = 22,  // of which fraction bits
    parameter integer RW = 34   // bits of the reach, which has the LSB of eye coordinates
) (
    input  wire                 clk,
    input  wire [1:0]           load,      // stage enables
    input  wire signed [CW-1:0] near_w,    // registers of the unit
    input  wire signed [CW-1:0] far_w,
    input  wire signed [VW-1:0] cosine_x,
    input  wire signed [VW-1:0] sine_x,
    input  wire signed [VW-1:0] cosine_y,
    input  wire signed [VW-1:0] sine_y,
    input  wire signed [CW-1:0] x,         // with load[0]
    input  wire signed [CW-1:0] y,
    input  wire signed [CW-1:0] w,
    input  wire signed [RW-1:0] reach,     // with load[1]
    output wire [5:0]           beyond     // left, right, bottom, top, near, far from bit 0 on
);
    localparam integer PW = CW + VW;       // a product
    // Sum of two products, or the reach with as many fraction bits, whichever is wider.
    localparam integer SW = (RW + VF > PW + 2) ? RW + VF : PW + 2;

    // The most negative number but one stands for the saturated least, too: formats may be
    // symmetric.
    localparam signed [CW-1:0] MOST = {1'b0, {CW-1{1'b1}}};

    function automatic at_end(input signed [CW-1:0] v);
        at_end = (v == MOST) | (v <= -MOST);
    endfunction

    // Stage 0. near and far are compared in CW + 1 bits.
    reg signed [PW-1:0] x_cosine, y_cosine, w_sine_x, w_sine_y;
    reg signed [CW:0]   before_near, behind_far;
    reg                 saturated;

    always_ff @(posedge clk) begin
        if (load[0]) begin
            x_cosine    <= PW'(x) * PW'(cosine_x);
            y_cosine    <= PW'(y) * PW'(cosine_y);
            w_sine_x    <= PW'(w) * PW'(sine_x);
            w_sine_y    <= PW'(w) * PW'(sine_y);
            before_near <= (CW+1)'(near_w) - (CW+1)'(w);
            behind_far  <= (CW+1)'(w) - (CW+1)'(far_w);
            saturated   <= at_end(x) | at_end(y) | at_end(w);
        end
    end

    // Stage 1.
    wire signed [SW-1:0] side_reach = SW'(reach) <<< VF;
    wire signed [SW-1:0] x_side     = SW'(x_cosine);
    wire signed [SW-1:0] y_side     = SW'(y_cosine);
    wire signed [SW-1:0] left       = -x_side - SW'(w_sine_x);
    wire signed [SW-1:0] right      = x_side - SW'(w_sine_x);
    wire signed [SW-1:0] bottom     = -y_side - SW'(w_sine_y);
    wire signed [SW-1:0] top        = y_side - SW'(w_sine_y);
    reg  [5:0]           planes;

    always_ff @(posedge clk) begin
        if (load[1]) begin
            planes <= saturated ? 6'd0
                    : {RW'(behind_far) > reach, RW'(before_near) > reach,
                       top > side_reach, bottom > side_reach,
                       right > side_reach, left > side_reach};
        end
    end

    assign beyond = planes;
endmodule

`default_nettype wire
