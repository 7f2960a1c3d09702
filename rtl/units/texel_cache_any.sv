`default_nettype none

// The one of N numbers that is not 0, if there is one. Combinational.
module texel_cache_any #(
    parameter integer N = 1
) (
    input  wire [3*N-1:0] numbers,  // at most one is not 0
    output reg  [2:0]     number
);
    integer i;

    always_comb begin
        number = 3'd0;
        for (i = 0; i < N; i = i + 1) number = number | numbers[3*i +: 3];
    end
endmodule

`default_nettype wire
