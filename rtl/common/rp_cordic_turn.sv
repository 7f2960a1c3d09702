`default_nettype none

// One register stage of rp_cordic: (a, b) turned by atan(2^-I), from b to a if `clockwise`.
module rp_cordic_turn #(
    parameter integer W = 28,  // bits of a and b
    parameter integer I = 0    // which step
) (
    input  wire                clk,
    input  wire                load,
    input  wire                clockwise,
    input  wire signed [W-1:0] in_a,
    input  wire signed [W-1:0] in_b,
    output reg  signed [W-1:0] out_a,
    output reg  signed [W-1:0] out_b
);
    wire signed [W-1:0] da = in_b >>> I;
    wire signed [W-1:0] db = in_a >>> I;

    always_ff @(posedge clk) begin
        if (load) begin
            out_a <= clockwise ? in_a + da : in_a - da;
            out_b <= clockwise ? in_b - db : in_b + db;
        end
    end
endmodule

`default_nettype wire
