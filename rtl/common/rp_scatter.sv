`default_nettype none

// Splits items, each with 0..N parts, into a stream of items without their parts and a stream of
// parts, one a cycle, in order. A part can leave in the cycle after its item was taken. An item is
// taken when there are places for N parts, so ready comes from registers alone.
//
// Time, with S(i) the number of parts before item i, P(m) the departure of part m, A of an item:
//     A(i) = max(V(i), A(i-1) + 1, R(i), P(S(i) + N - D - 1) + 1)   R: of the stream of items
//     P(m) = max(A(item of m) + 1, P(m-1) + 1, R'(m))               R': of the stream of parts
module rp_scatter #(
    parameter integer IW = 1,  // bits of an item
    parameter integer W  = 1,  // bits of a part
    parameter integer D  = 8,  // parts that are kept, >= N
    parameter integer N  = 4,  // parts of an item at most: 2, 4, 8 ..
    parameter integer NW = $clog2(N + 1)  // not to be set
) (
    input  wire           clk,
    input  wire           rst_n,       // synchronous, low: empty
    input  wire           in_valid,
    output wire           in_ready,
    input  wire [IW-1:0]  in_item,
    input  wire [NW-1:0]  in_n,        // parts of the item
    input  wire [N*W-1:0] in_parts,    // the first in the low bits
    output wire           item_valid,  // the item passes, unless a place for parts is missing
    input  wire           item_ready,  // from registers: a fifo, or rp_gather
    output wire [IW-1:0]  item,
    output wire [NW-1:0]  item_n,
    output wire           part_valid,
    input  wire           part_ready,
    output wire [W-1:0]   part
);
    localparam integer CW = $clog2(D + 1);

    wire [CW-1:0]  count;
    wire [N*W-1:0] oldest;
    wire           place = count <= CW'(D - N);
    wire           take  = in_valid & in_ready;

    assign in_ready   = place & item_ready;
    assign item_valid = in_valid & place;
    assign item       = in_item;
    assign item_n     = in_n;
    assign part_valid = count != '0;
    assign part       = oldest[W-1:0];

    rp_banks #(.W(W), .D(D), .N(N)) parts (
        .clk     (clk),
        .rst_n   (rst_n),
        .clear   (1'b0),
        .in_n    (take ? in_n : '0),
        .in_data (in_parts),
        .out_n   (NW'({part_valid & part_ready})),
        .out_data(oldest),
        .count   (count)
    );

    wire unused = &{1'b0, oldest[N*W-1:W]};
endmodule

`default_nettype wire
