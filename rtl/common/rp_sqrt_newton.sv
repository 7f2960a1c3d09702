`default_nettype none

// One Newton step of rp_inverse_sqrt: Y + Y (1 - D Y^2) / 2, in four register stages, one for each
// product. D and the exponent are carried along. D = in_d * 2^-32 in [1/4, 1), Y = in_y * 2^-31 in
// [1, 2).
module rp_sqrt_newton #(
    parameter integer ACTIVE = 1  // 0: Y is carried along, too
) (
    input  wire        clk,
    input  wire [3:0]  load,      // stage enables
    input  wire [31:0] in_d,
    input  wire [31:0] in_y,
    input  wire [5:0]  in_e,
    output wire [31:0] out_d,
    output wire [31:0] out_y,
    output wire [5:0]  out_e
);
    rp_delay #(.W(38), .L(4)) carried (
        .clk(clk), .load(load), .in_data({in_e, in_d}), .out_data({out_e, out_d})
    );

    generate
        if (ACTIVE != 0) begin : g_newton
            reg [31:0] d0, y0, y1, y2, y3;
            reg [31:0] square;                 // Y^2, u2.62 rounded to u2.30
            reg [63:0] product;                // D Y^2, u2.62
            reg signed [65:0] correction;      // Y E, s3.62

            wire [63:0]        wide    = {32'd0, in_y} * {32'd0, in_y} + 64'd2147483648;
            // E = 1 - D Y^2 in 62 fraction bits, rounded to 31.
            wire signed [65:0] residue = 66'sd4611686018427387904 - $signed({2'b00, product});
            wire signed [33:0] rounded = 34'((residue + 66'sd1073741824) >>> 31);
            // Half of it, in Y's fraction bits; rounding and few seeds may leave [1, 2).
            wire signed [65:0] next    = $signed({34'd0, y2}) + ((correction + 66'sd2147483648)
                                                                 >>> 32);

            always_ff @(posedge clk) begin
                if (load[0]) begin
                    d0     <= in_d;
                    y0     <= in_y;
                    square <= 32'(wide >> 32);
                end
                if (load[1]) begin
                    y1      <= y0;
                    product <= {32'd0, d0} * {32'd0, square};
                end
                if (load[2]) begin
                    y2         <= y1;
                    correction <= $signed({34'd0, y1}) * 66'(rounded);
                end
                if (load[3])
                    y3 <= (next < 66'sd2147483648) ? 32'h8000_0000
                        : (next > 66'sd4294967295) ? 32'hffff_ffff
                        : next[31:0];
            end

            assign out_y = y3;
        end else begin : g_plain
            rp_delay #(.W(32), .L(4)) plain (
                .clk(clk), .load(load), .in_data(in_y), .out_data(out_y)
            );
        end
    endgenerate
endmodule

`default_nettype wire
