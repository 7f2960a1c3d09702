`default_nettype none

// Turns one item into in_n beats, numbered out_j = 0 .. in_n - 1. The next item is taken in the
// cycle in which the last beat leaves, so beats follow each other without a gap. As in rp_pipe,
// an item's data is carried as `in_data` or kept in the user's registers enabled by `load`.
//
// Time: D(i,0) = max(A(i) + 1, R), D(i,j) = max(D(i,j-1) + 1, R), A(i+1) = max(V, D(i, last)).
module rp_expand #(
    parameter integer W  = 1,  // bits of an item
    parameter integer NW = 2   // bits of the number of beats
) (
    input  wire          clk,
    input  wire          rst_n,     // synchronous, low: empty
    input  wire          in_valid,
    output wire          in_ready,
    input  wire [W-1:0]  in_data,
    input  wire [NW-1:0] in_n,      // beats of this item, >= 1
    output wire          out_valid,
    input  wire          out_ready,
    output wire [W-1:0]  out_data,  // the item, the same for all its beats
    output wire [NW-1:0] out_j,     // number of the beat
    output wire          out_last,  // it is the item's last
    output wire          load       // an item is taken: enable of the user's own registers
);
    reg          valid;
    reg [W-1:0]  data;
    reg [NW-1:0] j;
    reg [NW-1:0] last;  // number of the item's last beat

    assign out_valid = valid;
    assign out_data  = data;
    assign out_j     = j;
    assign out_last  = j == last;
    assign in_ready  = ~valid | (out_ready & out_last);
    assign load      = in_valid & in_ready;

    always_ff @(posedge clk) begin
        if (!rst_n) valid <= 1'b0;
        else if (in_ready) valid <= in_valid;
    end

    always_ff @(posedge clk) begin
        if (load) begin
            data <= in_data;
            j    <= '0;
            last <= in_n - 1'b1;
        end else if (valid & out_ready) begin
            j <= j + 1'b1;
        end
    end
endmodule

`default_nettype wire
