`default_nettype none

// A queue of depth D with registered valid and ready: no combinational path between its sides.
//
// Time: latency 1, capacity D, backward latency 1. Full throughput needs D >= 2.
module rp_fifo #(
    parameter integer W = 1,  // bits of an entry
    parameter integer D = 2   // entries, >= 1
) (
    input  wire         clk,
    input  wire         rst_n,      // synchronous, low: empty
    input  wire         in_valid,
    output wire         in_ready,   // not full
    input  wire [W-1:0] in_data,
    output wire         out_valid,  // not empty
    input  wire         out_ready,
    output wire [W-1:0] out_data    // the oldest entry
);
    localparam integer PW = (D > 1) ? $clog2(D) : 1;  // a position, 0..D-1
    localparam integer CW = $clog2(D + 1);            // a count, 0..D
    localparam [PW-1:0] LAST = PW'(D - 1);
    localparam [CW-1:0] FULL = CW'(D);

    reg [W-1:0]  entries [0:D-1];
    reg [PW-1:0] head;              // where the oldest entry is
    reg [PW-1:0] tail;              // where the next entry goes
    reg [CW-1:0] count;

    wire push = in_valid & in_ready;
    wire pop  = out_valid & out_ready;

    assign in_ready  = count != FULL;
    assign out_valid = count != '0;
    assign out_data  = entries[head];

    always_ff @(posedge clk) begin
        if (!rst_n) begin
            head  <= '0;
            tail  <= '0;
            count <= '0;
        end else begin
            if (push) tail <= (tail == LAST) ? '0 : tail + 1'b1;
            if (pop) head <= (head == LAST) ? '0 : head + 1'b1;
            if (push & ~pop) count <= count + 1'b1;
            if (pop & ~push) count <= count - 1'b1;
        end
    end

    always_ff @(posedge clk) begin
        if (push) entries[tail] <= in_data;
    end
endmodule

`default_nettype wire
