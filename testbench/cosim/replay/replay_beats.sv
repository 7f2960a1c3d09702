`default_nettype none

// As replay_stream, for units that turn an item into several beats: a line of the vector file is
// registers and inputs, and the expected outputs are the lines of a second file, beat by beat.
// `out_last` is the output field that marks an item's last beat.
//
// Prints `mismatch BEAT CYCLE EXPECTED GOT` and at the end `done ITEMS MISMATCHES CYCLES`, where an
// item with a wrong beat is one mismatch.
module replay_beats #(
    parameter integer COUNT = 1,  // lines of the vector file: items
    parameter integer BEATS = 1,  // lines of the file of beats
    parameter integer RW    = 0,  // bits of the registers
    parameter integer IW    = 1,  // bits of the inputs
    parameter integer OW    = 1,  // bits of the outputs
    parameter integer LW    = RW + IW
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

    reg [LW-1:0]     vectors  [0:COUNT-1];
    reg [OW-1:0]     expected [0:BEATS-1];
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

    function automatic willing(input [31:0] percent);
        willing = ($unsigned($random(seed)) % 100) < percent;
    endfunction

    // The registers of a line.
    function automatic [LW-1:0] registers(input [LW-1:0] of_line);
        registers = of_line >> IW;
    endfunction

    initial begin
        if (!$value$plusargs("vectors=%s", file)) $fatal(1, "+vectors=FILE is missing");
        $readmemh(file, vectors);
        if (!$value$plusargs("beats=%s", file)) $fatal(1, "+beats=FILE is missing");
        $readmemh(file, expected);
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
                if (beats == BEATS || out_bits !== expected[beats]) begin
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
                if (beats != BEATS && mismatches == 0) mismatches = 1;
                $display("done %0d %0d %0d", received, mismatches, cycle);
                $finish;
            end
        end
    end
endmodule

`default_nettype wire
