`default_nettype none

// Streams a vector file through a unit, with random gaps before and stalls behind it, and compares
// what comes out. Independent of Verilator, of its C++ harness, and of the datapath: expected
// values come from the file.
//
// A line is registers, inputs, outputs, most significant first. A line with other registers waits
// until the unit is empty. Prints `mismatch INDEX CYCLE EXPECTED GOT` and at the end
// `done CASES MISMATCHES CYCLES`.
module replay_stream #(
    parameter integer COUNT = 1,  // lines of the file
    parameter integer RW    = 0,  // bits of the registers
    parameter integer IW    = 1,  // bits of the inputs
    parameter integer OW    = 1,  // bits of the outputs
    parameter integer LW    = RW + IW + OW
) (
    output reg           clk,
    output reg           rst_n,
    output reg  [LW-1:0] line,       // the line at the unit's input
    output reg           in_valid,
    input  wire          in_ready,
    input  wire          out_valid,
    output reg           out_ready,
    input  wire [OW-1:0] out_bits,
    output reg  [31:0]   eagerness   // percent: how willing everybody is just now
);
    // A unit that delivers nothing for so long is stuck.
    localparam integer PATIENCE = 100000;

    reg [LW-1:0]      vectors [0:COUNT-1];
    reg [8*1024-1:0]  file;
    integer           seed;
    integer           sent;
    integer           received;
    integer           mismatches;
    integer           cycle;
    integer           last_cycle;

    function automatic willing(input [31:0] percent);
        willing = ($unsigned($random(seed)) % 100) < percent;
    endfunction

    // The registers of a line.
    function automatic [LW-1:0] registers(input [LW-1:0] of_line);
        registers = of_line >> (IW + OW);
    endfunction

    initial begin
        if (!$value$plusargs("vectors=%s", file)) $fatal(1, "+vectors=FILE is missing");
        if (!$value$plusargs("seed=%d", seed)) seed = 1;
        $readmemh(file, vectors);
        clk        = 1'b0;
        rst_n      = 1'b0;
        in_valid   = 1'b0;
        out_ready  = 1'b0;
        eagerness  = 100;
        sent       = 0;
        received   = 0;
        mismatches = 0;
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
                if (out_bits !== vectors[received][OW-1:0]) begin
                    mismatches = mismatches + 1;
                    if (mismatches <= 100)
                        $display("mismatch %0d %0d %0h %0h", received, cycle,
                                 vectors[received][OW-1:0], out_bits);
                end
                received   = received + 1;
                last_cycle = cycle;
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
                $display("done %0d %0d %0d", received, mismatches, cycle);
                $finish;
            end
        end
    end
endmodule

`default_nettype wire
