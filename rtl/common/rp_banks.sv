`default_nettype none

// The storage of a queue that takes and gives up to N entries a cycle: N banks, each with one write
// and one read port. Successive entries lie in successive banks, so N of them never meet in one.
// No handshake: the user keeps `in_n` within the free places. What is put in appears at the output
// in the next cycle; who takes more than is there must know those entries from `in_data`.
module rp_banks #(
    parameter integer W = 1,  // bits of an entry
    parameter integer D = 8,  // entries, >= 1
    parameter integer N = 4,  // at most this many a cycle: 2, 4, 8 ..
    // Not to be set: bits of a number of entries in a cycle, 0..N, and in the queue, 0..D.
    parameter integer NW = $clog2(N + 1),
    parameter integer CW = $clog2(D + 1)
) (
    input  wire           clk,
    input  wire           rst_n,    // synchronous, low: empty
    input  wire           clear,    // drop all entries; what comes in this cycle stays
    input  wire [NW-1:0]  in_n,     // entries that come in
    input  wire [N*W-1:0] in_data,  // the first in the low bits
    input  wire [NW-1:0]  out_n,    // entries that are taken, at most what is there and comes in
    output wire [N*W-1:0] out_data, // the oldest N, the oldest in the low bits
    output reg  [CW-1:0]  count     // at the beginning of the cycle
);
    localparam integer ROWS = (D + N - 1) / N;
    localparam integer RW   = (ROWS > 1) ? $clog2(ROWS) : 1;  // a row, 0..ROWS-1
    localparam integer BW   = $clog2(N);                      // a bank
    localparam [RW-1:0] LAST = RW'(ROWS - 1);

    reg [RW-1:0] head_row, tail_row;    // where the oldest entry is, and where the next one goes
    reg [BW-1:0] head_bank, tail_bank;

    function automatic [RW-1:0] next_row(input [RW-1:0] row);
        next_row = (row == LAST) ? '0 : row + 1'b1;
    endfunction

    // A position n entries further on, n <= N: one row at most.
    function automatic [RW+BW-1:0] advance(
        input [RW-1:0] row,
        input [BW-1:0] bank,
        input [NW-1:0] n
    );
        advance[BW-1:0] = BW'(NW'(bank) + n);
        advance[RW+BW-1:BW] = (NW'(bank) + n >= NW'(N)) ? next_row(row) : row;
    endfunction

    wire [RW-1:0] from_row  = clear ? head_row : tail_row;
    wire [BW-1:0] from_bank = clear ? head_bank : tail_bank;

    always_ff @(posedge clk) begin
        if (!rst_n) begin
            {head_row, head_bank} <= '0;
            {tail_row, tail_bank} <= '0;
            count                 <= '0;
        end else begin
            {head_row, head_bank} <= advance(head_row, head_bank, out_n);
            {tail_row, tail_bank} <= advance(from_row, from_bank, in_n);
            count                 <= (clear ? '0 : count) + CW'(in_n) - CW'(out_n);
        end
    end

    wire [N*W-1:0] read;  // one entry of each bank

    genvar b;
    generate
        for (b = 0; b < N; b = b + 1) begin : g_bank
            reg [W-1:0] entries [0:ROWS-1];
            // Which of the incoming entries, and of the oldest, is this bank's.
            wire [BW-1:0] incoming = BW'(b) - from_bank;
            wire [BW-1:0] oldest   = head_bank + BW'(b);
            wire [RW-1:0] row_in   = (NW'(b) < NW'(from_bank)) ? next_row(from_row) : from_row;
            wire [RW-1:0] row_out  = (NW'(b) < NW'(head_bank)) ? next_row(head_row) : head_row;

            always_ff @(posedge clk) begin
                if (NW'(incoming) < in_n) entries[row_in] <= in_data[incoming*W +: W];
            end

            assign read[b*W +: W]     = entries[row_out];
            assign out_data[b*W +: W] = read[oldest*W +: W];
        end
    endgenerate
endmodule

`default_nettype wire
