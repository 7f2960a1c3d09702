`default_nettype none

// Which way of a set makes way for the next line. REPLACEMENT 0: the ways in turn, a pointer a set.
// 1: the least recently used one; each way has an age, 0 for the one read last, and touching a way
// ages those that were younger. A set without lines counts from the beginning, whatever stands in
// its registers: nothing need be cleared when lines are dropped, and way 0 is filled first.
module texel_cache_order #(
    parameter integer SETS        = 1,
    parameter integer SW          = 1,  // bits of a set's number
    parameter integer WAYS        = 1,
    parameter integer REPLACEMENT = 0
) (
    input  wire          clk,
    input  wire [SW-1:0] set,
    input  wire          empty,   // the set has no line
    input  wire          fill,    // the victim gets a line
    input  wire          read,    // the way `used` is read
    input  wire [2:0]    used,
    output wire [2:0]    victim
);
    localparam integer AW = (WAYS > 1) ? $clog2(WAYS) : 1;  // a way, an age: 0..WAYS-1
    localparam [AW-1:0] LAST = AW'(WAYS - 1);

    generate
        if (REPLACEMENT == 0) begin : g_oldest
            reg  [AW-1:0] next [0:SETS-1];
            wire [AW-1:0] oldest = empty ? '0 : next[set];
            wire          unused = &{1'b0, read, used};

            always_ff @(posedge clk) begin
                if (fill) next[set] <= (oldest == LAST) ? '0 : oldest + 1'b1;
            end

            assign victim = 3'(oldest);
        end else begin : g_least_recent
            reg  [WAYS*AW-1:0] ages [0:SETS-1];
            wire [WAYS*AW-1:0] stored = ages[set];
            wire [WAYS*AW-1:0] current;
            wire [WAYS*AW-1:0] aged;
            wire [3*WAYS-1:0]  found;    // the way's number if it is the oldest, else 0
            wire [2:0]         touched = fill ? victim : used;
            wire [AW-1:0]      age     = current[touched*AW +: AW];

            genvar w;
            for (w = 0; w < WAYS; w = w + 1) begin : g_way
                wire [AW-1:0] own = empty ? AW'(WAYS - 1 - w) : stored[w*AW +: AW];

                assign current[w*AW +: AW] = own;
                assign aged[w*AW +: AW] = (touched == 3'(w)) ? '0 : (own < age) ? own + 1'b1 : own;
                assign found[3*w +: 3] = (own == LAST) ? 3'(w) : 3'd0;
            end

            // The ages of a set are all different: one way is the oldest.
            texel_cache_any #(.N(WAYS)) oldest (.numbers(found), .number(victim));

            always_ff @(posedge clk) begin
                if (fill | read) ages[set] <= aged;
            end
        end
    endgenerate
endmodule

`default_nettype wire
