`default_nettype none

// Streams a vector file through a unit, with random gaps before and stalls behind it, and compares
// what comes out. Independent of Verilator, of its C++ harness, and of the datapath: expected
// values come from the file.
//
// A line is an item: registers, inputs, outputs, most significant first. A line with other
// registers waits until the unit is empty. Of units that turn an item into several beats (BEATS
// above 0), it has no outputs: those are the lines of a second file, beat by beat, and `out_last`
// is the output field that marks an item's last beat; else it is 1.
//
// Prints `mismatch BEAT CYCLE EXPECTED GOT` and at the end `done ITEMS MISMATCHES CYCLES`, where an
// item with a wrong beat is one mismatch.
module replay_stream #(
    parameter integer COUNT = 1,  // lines of the vector file: items
    parameter integer BEATS = 0,  // lines of the file of beats; 0: each item is one beat
    parameter integer RW    = 0,  // bits of the registers
    parameter integer IW    = 1,  // bits of the inputs
    parameter integer OW    = 1,  // bits of the outputs
    // Not to be set: bits of the outputs in a line, and of a line.
    parameter integer TW    = (BEATS == 0) ? OW : 0,
    parameter integer LW    = RW + IW + TW
) (
    output reg           clk,
    output reg           rst_n,
    output reg  [LW-1:0] line,       // the line at the unit's input
    output reg           in_valid,
    input  wire          in_ready,
    input  wire          out_valid,
    output reg           out_ready,
    input  wire [OW-1:0] out_bits,
    input  wire          out_last,
    output reg  [31:0]   eagerness   // percent: how willing everybody is just now
);
    // A unit that delivers nothing for so long is stuck.
    localparam integer PATIENCE = 100000;
    localparam integer TOTAL    = (BEATS == 0) ? COUNT : BEATS;

    reg [LW-1:0]     vectors  [0:COUNT-1];
    reg [OW-1:0]     expected [0:TOTAL-1];
    reg [8*1024-1:0] file;
    reg              wrong;        // some beat of this item differs
    integer          seed;
    integer          sent;
    integer          beats;        // that came out
    integer          received;     // items that came out
    integer          mismatches;
    integer          reported;
    integer          cycle;
    integer          last_cycle;
    integer          i;

    function automatic willing(input [31:0] percent);
        willing = ($unsigned($random(seed)) % 100) < percent;
    endfunction

    // The registers of a line.
    function automatic [LW-1:0] registers(input [LW-1:0] of_line);
        registers = of_line >> (IW + TW);
    endfunction

    initial begin
        if (!$value$plusargs("vectors=%s", file)) $fatal(1, "+vectors=FILE is missing");
        $readmemh(file, vectors);
        if (BEATS == 0) begin
            for (i = 0; i < COUNT; i = i + 1) expected[i] = vectors[i];  // its low bits
        end else begin
            if (!$value$plusargs("beats=%s", file)) $fatal(1, "+beats=FILE is missing");
            $readmemh(file, expected);
        end
        if (!$value$plusargs("seed=%d", seed)) seed = 1;
        clk        = 1'b0;
        rst_n      = 1'b0;
        in_valid   = 1'b0;
        out_ready  = 1'b0;
        wrong      = 1'b0;
        eagerness  = 100;
        sent       = 0;
        beats      = 0;
        received   = 0;
        mismatches = 0;
        reported   = 0;
        cycle      = 0;
        last_cycle = 0;
        line       = vectors[0];
        repeat (4) #1 clk = ~clk;
        rst_n = 1'b1;
        forever #1 clk = ~clk;
    end

    always @(posedge clk) begin
        if (rst_n) begin
            if (out_valid && out_ready) begin
                if (beats == TOTAL || out_bits !== expected[beats]) begin
                    wrong = 1'b1;
                    reported = reported + 1;
                    if (reported <= 100)
                        $display("mismatch %0d %0d %0h %0h", beats, cycle, expected[beats],
                                 out_bits);
                end
                beats      = beats + 1;
                last_cycle = cycle;
                if (out_last !== 1'b0) begin
                    received   = received + 1;
                    mismatches = mismatches + (wrong ? 1 : 0);
                    wrong      = 1'b0;
                end
            end
            if (in_valid && in_ready) sent = sent + 1;

            if (!in_valid || in_ready) begin
                in_valid <= 1'b0;
                if (sent < COUNT && willing(eagerness)
                    && (received == sent || registers(vectors[sent]) == registers(line))) begin
                    in_valid <= 1'b1;
                    line     <= vectors[sent];
                end
            end
            out_ready <= willing(eagerness);

            // The mood changes now and then: full speed, halting, nearly asleep.
            if (cycle % 4096 == 0)
                eagerness <= (cycle % 16384 == 0) ? 100 : 10 + $unsigned($random(seed)) % 90;

            cycle = cycle + 1;
            if (received == COUNT || cycle > last_cycle + PATIENCE) begin
                if (received == COUNT && beats != TOTAL && mismatches == 0) mismatches = 1;
                $display("done %0d %0d %0d", received, mismatches, cycle);
                $finish;
            end
        end
    end
endmodule

`default_nettype wire
