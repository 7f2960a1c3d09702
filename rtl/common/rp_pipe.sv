`default_nettype none

// A pipeline of L register stages with valid/ready on both sides. Empty stages are filled even
// while the output is stalled (bubbles collapse); `in_ready` follows `out_ready` in the same cycle.
//
// A unit's datapath is either carried as `in_data` or, where stages compute, kept in the unit's
// own registers, each enabled by its bit of `load`; W may then be 1 and in_data tied off.
//
// Time: A(i) = max(V(i), A(i-1) + 1, D(i-L)),  D(i) = max(A(i) + L, D(i-1) + 1, R(i)).
module rp_pipe #(
    parameter integer W = 1,  // bits of data carried along
    parameter integer L = 1   // stages, >= 1
) (
    input  wire          clk,
    input  wire          rst_n,      // synchronous, low: all stages empty
    input  wire          in_valid,
    output wire          in_ready,
    input  wire  [W-1:0] in_data,
    output wire          out_valid,
    input  wire          out_ready,
    output wire  [W-1:0] out_data,
    output wire  [L-1:0] load        // load[s]: the registers of stage s take new contents
);
    reg  [L-1:0]   valid;                          // valid[s]: stage s holds an item
    reg  [L*W-1:0] data;                           // of all stages, stage 0 in the low bits

    wire [L:0]         occupied = {valid, in_valid};   // what stands before stage 0, and in 0..L-1
    wire [(L+1)*W-1:0] contents = {data, in_data};
    wire [L-1:0]       ready;                      // ready[s]: stage s is empty or will be
    wire [L*W-1:0]     taken;                      // load, once for each bit of data

    assign in_ready  = ready[0];
    assign out_valid = occupied[L];
    assign out_data  = contents[L*W +: W];
    assign load      = occupied[L-1:0] & ready;

    // The closed form (some stage from here on is empty) instead of a chain from stage to stage:
    // no combinational order within one vector, and no path that grows with L.
    genvar s;
    generate
        for (s = 0; s < L; s = s + 1) begin : g_stage
            assign ready[s] = out_ready | ~(&valid[L-1:s]);
            assign taken[s*W +: W] = {W{load[s]}};
        end
    endgenerate

    always_ff @(posedge clk) begin
        if (!rst_n) valid <= '0;
        else valid <= load | (valid & ~ready);
    end

    always_ff @(posedge clk) begin
        data <= (contents[L*W-1:0] & taken) | (data & ~taken);
    end
endmodule

`default_nettype wire
