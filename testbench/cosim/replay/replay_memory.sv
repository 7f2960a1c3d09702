`default_nettype none

// The memory behind a unit's read port in a replay: N entries a request, answers in order after a
// random time. A table begins at `first_entry` of the file and has `columns` entries a row.
module replay_memory #(
    parameter integer DW      = 1,        // bits of an entry
    parameter integer N       = 1,        // entries a request
    parameter integer AW      = 13,       // bits of a coordinate
    parameter integer ENTRIES = 1         // lines of the file
) (
    input  wire            clk,
    input  wire            rst_n,
    input  wire [31:0]     eagerness,     // percent
    input  wire [31:0]     first_entry,
    input  wire [31:0]     columns,
    input  wire            valid,
    output reg             ready,
    input  wire [N-1:0]    read,
    input  wire [N*AW-1:0] x,
    input  wire [N*AW-1:0] y,
    output reg             rvalid,
    input  wire            rready,
    output reg  [N*DW-1:0] rdata
);
    localparam integer PENDING = 64;

    reg [DW-1:0]     entries [0:ENTRIES-1];
    reg [N*DW-1:0]   pending [0:PENDING-1];
    reg [8*1024-1:0] file;
    integer          seed;
    integer          head;
    integer          tail;
    integer          i;

    initial begin
        if (!$value$plusargs("tables=%s", file)) $fatal(1, "+tables=FILE is missing");
        if (!$value$plusargs("seed=%d", seed)) seed = 1;
        $readmemh(file, entries);
        head   = 0;
        tail   = 0;
        ready  = 1'b0;
        rvalid = 1'b0;
    end

    always @(posedge clk) begin
        if (rst_n) begin
            if (rvalid && rready) head = head + 1;
            if (valid && ready) begin
                for (i = 0; i < N; i = i + 1)
                    pending[tail % PENDING][i*DW +: DW] = read[i]
                        ? entries[first_entry + y[i*AW +: AW] * columns + x[i*AW +: AW]]
                        : {DW{1'bx}};
                tail = tail + 1;
            end
            ready <= (tail - head < PENDING - 1) && ($unsigned($random(seed)) % 100 < eagerness);
            // An answer that was offered stays.
            if (head == tail) rvalid <= 1'b0;
            else if ((rvalid && !rready) || $unsigned($random(seed)) % 100 < eagerness) begin
                rvalid <= 1'b1;
                rdata  <= pending[head % PENDING];
            end else rvalid <= 1'b0;
        end
    end
endmodule

`default_nettype wire
