`default_nettype none

// The client side of a memory port: sends one read a beat, and hands the answer on together with
// the beat's tag. (The address goes to the port directly, past this module.) A place for the answer is reserved before the request is sent, so answers are
// never refused: whatever stands between client and memory cannot be blocked by this client, which
// is what makes shared paths free of deadlock. Beats with in_read = 0 read nothing and pass in
// order.
//
// Answers must come in the order of the requests. `mem_ready` must not depend on `mem_valid`.
//
// Time, with a memory that answers M cycles after a request: latency M + 1, capacity K, backward
// latency 1. One read a cycle needs K >= M + 2.
module rp_client #(
    parameter integer DW = 1,  // bits of an answer
    parameter integer TW = 1,  // bits of a tag
    parameter integer K  = 4   // beats in flight
) (
    input  wire          clk,
    input  wire          rst_n,          // synchronous, low: nothing in flight
    input  wire          in_valid,
    output wire          in_ready,
    input  wire          in_read,        // this beat reads
    input  wire [TW-1:0] in_tag,
    output wire          mem_valid,      // a request
    input  wire          mem_ready,
    input  wire          mem_rvalid,     // an answer
    output wire          mem_rready,     // always: its place is reserved
    input  wire [DW-1:0] mem_rdata,
    output wire          out_valid,
    input  wire          out_ready,
    output wire [TW-1:0] out_tag,
    output wire          out_read,
    output wire [DW-1:0] out_data        // the answer, if out_read
);
    wire place;        // the order queue, and with it the answer queue, has a place
    wire beat_valid;   // the oldest beat in flight
    wire data_valid;   // the oldest answer
    wire unused_full;  // the answer queue is never full when an answer comes

    // A beat enters when its request is taken; both readies come from registers, or from outside.
    assign in_ready   = place & (mem_ready | ~in_read);
    assign mem_valid  = in_valid & in_read & place;
    assign mem_rready = 1'b1;

    rp_fifo #(.W(TW + 1), .D(K)) order (
        .clk      (clk),
        .rst_n    (rst_n),
        .in_valid (in_valid & (mem_ready | ~in_read)),
        .in_ready (place),
        .in_data  ({in_read, in_tag}),
        .out_valid(beat_valid),
        .out_ready(out_ready & (data_valid | ~out_read)),
        .out_data ({out_read, out_tag})
    );

    rp_fifo #(.W(DW), .D(K)) answers (
        .clk      (clk),
        .rst_n    (rst_n),
        .in_valid (mem_rvalid),
        .in_ready (unused_full),
        .in_data  (mem_rdata),
        .out_valid(data_valid),
        .out_ready(out_ready & beat_valid & out_read),
        .out_data (out_data)
    );

    assign out_valid = beat_valid & (data_valid | ~out_read);
endmodule

`default_nettype wire
