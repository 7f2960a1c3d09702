`default_nettype none

// Data carried through L stages of a unit's pipeline, beside those that compute.
module rp_delay #(
    parameter integer W = 1,  // bits
    parameter integer L = 1   // stages, >= 1
) (
    input  wire         clk,
    input  wire [L-1:0] load,      // stage enables, of the unit's rp_pipe
    input  wire [W-1:0] in_data,
    output wire [W-1:0] out_data
);
    reg  [L*W-1:0]     data;                       // of all stages, stage 0 in the low bits
    wire [(L+1)*W-1:0] contents = {data, in_data};

    assign out_data = contents[L*W +: W];

    integer s;
    always_ff @(posedge clk)
        for (s = 0; s < L; s = s + 1) if (load[s]) data[s*W +: W] <= contents[s*W +: W];
endmodule

`default_nettype wire
