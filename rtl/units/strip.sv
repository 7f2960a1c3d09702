`default_nettype none

// The stripping unit (Gumhold and Huettner 1999, section 2.3): four registers for displaced
// vertices, from which sequential strips are built, every second triangle wound the other way, and
// two FIFOs that keep vertices for the sweep's next column and second half.
//
// A whole step, up to four commands, is taken in a cycle. The commands are worked out one after the
// other on names of vertices (strip_command); then vertices are fetched, all at once: new ones from
// the ports, others from registers and FIFOs. They are opaque.
//
// Time: latency 1, one step a cycle, in_ready follows out_ready.
module strip #(
`include "rtl/units/strip_params.svh"
    , parameter integer VERTEX_WIDTH = 32        // bits of a vertex
) (
    input  wire                    clk,
    input  wire                    rst_n,        // synchronous, low: nothing is held

    input  wire                    in_valid,
    output wire                    in_ready,
    input  wire                    flush,        // forget strip, registers and FIFOs first
    input  wire                    init,         // then start a new strip
    input  wire                    flip,         // with init: swap the last two of a triangle
    input  wire [2:0]              count,        // commands, 0..4
    input  wire [5:0]              command0,     // operation, register, where the vertex is kept
    input  wire [5:0]              command1,
    input  wire [5:0]              command2,
    input  wire [5:0]              command3,
    input  wire [VERTEX_WIDTH-1:0] vertex0,      // of the first command that is new
    input  wire [VERTEX_WIDTH-1:0] vertex1,
    input  wire [VERTEX_WIDTH-1:0] vertex2,
    input  wire [VERTEX_WIDTH-1:0] vertex3,

    output wire                    out_valid,
    input  wire                    out_ready,
    output reg  [1:0]              triangles,    // made by the step, 0..2
    output reg                     bad_ref,      // a command could not be carried out
    output reg  [VERTEX_WIDTH-1:0] a0,           // the first triangle, undefined if not made
    output reg  [VERTEX_WIDTH-1:0] b0,
    output reg  [VERTEX_WIDTH-1:0] c0,
    output reg  [VERTEX_WIDTH-1:0] a1,           // the second
    output reg  [VERTEX_WIDTH-1:0] b1,
    output reg  [VERTEX_WIDTH-1:0] c1
);
    localparam integer W  = VERTEX_WIDTH;
    localparam integer CW = (COLUMN_DEPTH > 0) ? $clog2(COLUMN_DEPTH + 1) : 1;

    wire load;
    wire unused_carried;

    rp_pipe #(.W(1), .L(1)) stage (
        .clk      (clk),
        .rst_n    (rst_n),
        .in_valid (in_valid),
        .in_ready (in_ready),
        .in_data  (1'b0),
        .out_valid(out_valid),
        .out_ready(out_ready),
        .out_data (unused_carried),
        .load     (load)
    );

    // ---- names ----------------------------------------------------------------------------------
    // See strip_command for the fields. Registers begin a step with their own names.
    localparam [11:0] OWN_NAMES = {3'd3, 3'd2, 3'd1, 3'd0};

    reg [6:0]       last_strip;  // {length, odd, older, newer}
    reg [3:0]       loaded;
    reg [4*W-1:0]   registers;
    wire [CW-1:0]   column_count;
    wire [CW-1:0]   split_count;

    wire [6:0]      strip0 = init ? {2'd0, flip, 4'd0} : flush ? '0 : last_strip;
    wire [15:0]     registers0 = {loaded & ~{4{flush}}, OWN_NAMES};
    wire [CW+13:0]  column0 = {column_count & ~{CW{flush}}, 14'd0};
    wire [CW+13:0]  split0  = {split_count & ~{CW{flush}}, 14'd0};

    wire [6:0]      strip1, strip2, strip3, strip4;
    wire [15:0]     registers1, registers2, registers3, registers4;
    wire [CW+13:0]  column1, column2, column3, column4;
    wire [CW+13:0]  split1, split2, split3, split4;
    wire [20:0]     made1, made2, made3, made4;
    wire [2:0]      news1, news2, news3, unused_news;
    wire [7:0]      source, number;

    strip_command #(.NUMBER(0), .DEPTH(COLUMN_DEPTH), .CW(CW)) first (
        .active(count > 3'd0), .command(command0),
        .strip_in(strip0), .strip_out(strip1),
        .registers_in(registers0), .registers_out(registers1),
        .column_in(column0), .column_out(column1), .split_in(split0), .split_out(split1),
        .made_in(21'd0), .made_out(made1), .news_in(3'd0), .news_out(news1),
        .source(source[1:0]), .number(number[1:0])
    );
    strip_command #(.NUMBER(1), .DEPTH(COLUMN_DEPTH), .CW(CW)) second (
        .active(count > 3'd1), .command(command1),
        .strip_in(strip1), .strip_out(strip2),
        .registers_in(registers1), .registers_out(registers2),
        .column_in(column1), .column_out(column2), .split_in(split1), .split_out(split2),
        .made_in(made1), .made_out(made2), .news_in(news1), .news_out(news2),
        .source(source[3:2]), .number(number[3:2])
    );
    strip_command #(.NUMBER(2), .DEPTH(COLUMN_DEPTH), .CW(CW)) third (
        .active(count > 3'd2), .command(command2),
        .strip_in(strip2), .strip_out(strip3),
        .registers_in(registers2), .registers_out(registers3),
        .column_in(column2), .column_out(column3), .split_in(split2), .split_out(split3),
        .made_in(made2), .made_out(made3), .news_in(news2), .news_out(news3),
        .source(source[5:4]), .number(number[5:4])
    );
    strip_command #(.NUMBER(3), .DEPTH(COLUMN_DEPTH), .CW(CW)) fourth (
        .active(count > 3'd3), .command(command3),
        .strip_in(strip3), .strip_out(strip4),
        .registers_in(registers3), .registers_out(registers4),
        .column_in(column3), .column_out(column4), .split_in(split3), .split_out(split4),
        .made_in(made3), .made_out(made4), .news_in(news3), .news_out(unused_news),
        .source(source[7:6]), .number(number[7:6])
    );

    // ---- vertices -------------------------------------------------------------------------------
    wire [4*W-1:0] fresh = {vertex3, vertex2, vertex1, vertex0};
    wire [4*W-1:0] column_oldest;
    wire [4*W-1:0] split_oldest;
    wire [4*W-1:0] own;                          // each command's own vertex
    wire [8*W-1:0] named = {own, registers};     // by name

    genvar k;
    generate
        for (k = 0; k < 4; k = k + 1) begin : g_own
            wire [1:0] from = number[k*2 +: 2];
            assign own[k*W +: W] = (source[k*2 +: 2] == 2'd1) ? column_oldest[from*W +: W]
                                 : (source[k*2 +: 2] == 2'd2) ? split_oldest[from*W +: W]
                                 : fresh[from*W +: W];
        end
    endgenerate

    function automatic [W-1:0] vertex(input [2:0] name, input [8*W-1:0] all);
        vertex = all[name*W +: W];
    endfunction

    // ---- state ----------------------------------------------------------------------------------
    always_ff @(posedge clk) begin
        if (!rst_n) begin
            last_strip <= '0;
            loaded     <= '0;
        end else if (load) begin
            last_strip <= strip4;
            loaded     <= registers4[15:12];
        end
    end

    always_ff @(posedge clk) begin
        if (load) begin
            registers <= {vertex(registers4[11:9], named), vertex(registers4[8:6], named),
                          vertex(registers4[5:3], named), vertex(registers4[2:0], named)};
            bad_ref   <= made4[20];
            triangles <= made4[19:18];
            a1        <= vertex(made4[17:15], named);
            b1        <= vertex(made4[14:12], named);
            c1        <= vertex(made4[11:9], named);
            a0        <= vertex(made4[8:6], named);
            b0        <= vertex(made4[5:3], named);
            c0        <= vertex(made4[2:0], named);
        end
    end

    generate
        if (COLUMN_DEPTH > 0) begin : g_fifos
            wire [4*W-1:0] column_kept = {
                own[column4[7:6]*W +: W], own[column4[5:4]*W +: W],
                own[column4[3:2]*W +: W], own[column4[1:0]*W +: W]};
            wire [4*W-1:0] split_kept = {
                own[split4[7:6]*W +: W], own[split4[5:4]*W +: W],
                own[split4[3:2]*W +: W], own[split4[1:0]*W +: W]};

            rp_banks #(.W(W), .D(COLUMN_DEPTH), .N(4)) column_fifo (
                .clk(clk), .rst_n(rst_n), .clear(load & flush),
                .in_n(column4[10:8] & {3{load}}), .in_data(column_kept),
                .out_n(column4[13:11] & {3{load}}), .out_data(column_oldest),
                .count(column_count)
            );
            rp_banks #(.W(W), .D(COLUMN_DEPTH), .N(4)) split_fifo (
                .clk(clk), .rst_n(rst_n), .clear(load & flush),
                .in_n(split4[10:8] & {3{load}}), .in_data(split_kept),
                .out_n(split4[13:11] & {3{load}}), .out_data(split_oldest),
                .count(split_count)
            );
            wire unused = &{1'b0, column4[CW+13:14], split4[CW+13:14]};
        end else begin : g_no_fifos
            assign column_count  = '0;
            assign split_count   = '0;
            assign column_oldest = '0;
            assign split_oldest  = '0;
            wire unused = &{1'b0, column4, split4};
        end
    endgenerate
endmodule

`default_nettype wire
