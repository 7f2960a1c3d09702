`default_nettype none

// The inverse of rp_scatter: joins a stream of items and a stream of parts. An item leaves, with
// its 0..N parts, when all of them are there; parts come in the order of their items.
//
// Time, with A of an item, P(m) the arrival of part m, T(i) the departure of item i, S(i) the
// number of parts before item i:
//     A(i) = max(V(i), A(i-1) + 1, T(i-DI) + 1)
//     P(m) = max(V'(m), P(m-1) + 1, T(item of m-D) + 1)
//     T(i) = max(A(i) + 1, P(S(i+1)-1) + 1 if it has parts, T(i-1) + 1, R(i))
// Between rp_scatter and here, DI must exceed the number of parts that may be on their way, or
// items hold them up.
module rp_gather #(
    parameter integer IW = 1,  // bits of an item
    parameter integer W  = 1,  // bits of a part
    parameter integer DI = 2,  // items that are kept
    parameter integer D  = 8,  // parts that are kept, >= N
    parameter integer N  = 4,  // parts of an item at most: 2, 4, 8 ..
    parameter integer NW = $clog2(N + 1)  // not to be set
) (
    input  wire           clk,
    input  wire           rst_n,       // synchronous, low: empty
    input  wire           item_valid,
    output wire           item_ready,
    input  wire [IW-1:0]  item,
    input  wire [NW-1:0]  item_n,      // parts of the item
    input  wire           part_valid,
    output wire           part_ready,
    input  wire [W-1:0]   part,
    output wire           out_valid,
    input  wire           out_ready,
    output wire [IW-1:0]  out_item,
    output wire [NW-1:0]  out_n,
    output wire [N*W-1:0] out_parts    // the first in the low bits; out_n of them mean something
);
    localparam integer CW = $clog2(D + 1);

    wire [CW-1:0] count;
    wire          waiting;                                // an item
    wire          complete = count >= CW'(out_n);
    wire          leave    = waiting & complete & out_ready;

    assign out_valid  = waiting & complete;
    assign part_ready = count != CW'(D);

    rp_fifo #(.W(IW + NW), .D(DI)) items (
        .clk      (clk),
        .rst_n    (rst_n),
        .in_valid (item_valid),
        .in_ready (item_ready),
        .in_data  ({item, item_n}),
        .out_valid(waiting),
        .out_ready(out_ready & complete),
        .out_data ({out_item, out_n})
    );

    rp_banks #(.W(W), .D(D), .N(N)) parts (
        .clk     (clk),
        .rst_n   (rst_n),
        .clear   (1'b0),
        .in_n    (NW'({part_valid & part_ready})),
        .in_data ({{((N-1)*W){1'b0}}, part}),
        .out_n   (leave ? out_n : '0),
        .out_data(out_parts),
        .count   (count)
    );
endmodule

`default_nettype wire
