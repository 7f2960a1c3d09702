`default_nettype none

// Leads items past a unit that keeps their order and number: a word of each waits in a queue while
// the rest of the item is in the unit, and joins what the unit makes of it. For units that do not
// have stages to delay the word by.
//
// `unit_ready` must not depend on `unit_valid`. The word is there before the unit's answer if the
// unit's latency is 1 or more, so the latency is the unit's. D places let through what the unit
// holds; with fewer, D is the capacity.
module rp_beside #(
    parameter integer W = 1,  // bits of the word
    parameter integer D = 2   // words that wait at most
) (
    input  wire         clk,
    input  wire         rst_n,       // synchronous, low: no word waits
    input  wire         in_valid,
    output wire         in_ready,
    input  wire [W-1:0] in_data,     // the word
    output wire         unit_valid,  // the item, to the unit
    input  wire         unit_ready,
    input  wire         done_valid,  // the item, from the unit
    output wire         done_ready,
    output wire         out_valid,   // both together
    input  wire         out_ready,
    output wire [W-1:0] out_data
);
    wire place;  // for another word
    wire word;   // the oldest one

    assign in_ready   = place & unit_ready;
    assign unit_valid = in_valid & place;
    assign out_valid  = word & done_valid;
    assign done_ready = word & out_ready;

    rp_fifo #(.W(W), .D(D)) words (
        .clk      (clk),
        .rst_n    (rst_n),
        .in_valid (in_valid & unit_ready),
        .in_ready (place),
        .in_data  (in_data),
        .out_valid(word),
        .out_ready(out_ready & done_valid),
        .out_data (out_data)
    );
endmodule

`default_nettype wire
