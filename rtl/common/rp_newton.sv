`default_nettype none

// One Newton step of rp_reciprocal: Y + Y (1 - D Y), in two register stages. D and the exponent are
// carried along. D = in_d * 2^-32 in [1/2, 1), Y = in_y * 2^-31 in [1, 2].
module rp_newton #(
    parameter integer ACTIVE = 1  // 0: Y is carried along, too
) (
    input  wire        clk,
    input  wire [1:0]  load,      // stage enables
    input  wire [31:0] in_d,
    input  wire [32:0] in_y,
    input  wire [5:0]  in_e,
    output reg  [31:0] out_d,
    output reg  [32:0] out_y,
    output reg  [5:0]  out_e
);
    reg [31:0] d;
    reg [32:0] y;
    reg [5:0]  e;

    always_ff @(posedge clk) begin
        if (load[0]) begin
            d <= in_d;
            y <= in_y;
            e <= in_e;
        end
        if (load[1]) begin
            out_d <= d;
            out_e <= e;
        end
    end

    generate
        if (ACTIVE != 0) begin : g_newton
            // E = 1 - D Y, s0.63 since |E| < 1/2, rounded to 31 fraction bits.
            wire [64:0]        dy      = {33'd0, in_d} * {32'd0, in_y};
            wire signed [64:0] residue = 65'sd9223372036854775808 - $signed(dy);
            reg  signed [31:0] error;
            // Y E: 34 x 32 bits with signs, rounded to Y's fraction bits. Few seeds or rounding may
            // leave 1..2, the range of 1/D.
            wire signed [65:0] product = $signed({33'd0, y}) * 66'(error);
            wire signed [65:0] next    = $signed({33'd0, y})
                                       + ((product + 66'sd1073741824) >>> 31);

            always_ff @(posedge clk) begin
                if (load[0]) error <= 32'((residue + 65'sd2147483648) >>> 32);
                if (load[1])
                    out_y <= (next < 66'sd2147483648) ? 33'd2147483648
                           : (next > 66'sd4294967296) ? 33'd4294967296
                           : next[32:0];
            end
        end else begin : g_plain
            always_ff @(posedge clk) if (load[1]) out_y <= y;
        end
    endgenerate
endmodule

`default_nettype wire
