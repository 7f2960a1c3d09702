`default_nettype none

// The data of one vertex on its way out: a corner's as they came, all others rounded half up to the
// LSB of the data. Combinational.
module sweep_line_vertex #(
    parameter integer C     = 13,
    parameter integer VW    = 32,               // bits of a value: data and guard bits
    parameter integer DW    = 32                // bits of data
) (
    input  wire              is_corner,
    input  wire [1:0]        part,              // which corner
    input  wire [2:0]        source,            // which value: see sweep_line_send
    input  wire [3*C*DW-1:0] corners,           // corner 0 in the high bits
    input  wire [5*C*VW-1:0] values,            // right, left, edge one step on, edge, start
    output wire [C*DW-1:0]   data
);
    localparam integer GUARD = VW - DW;

    wire [C*VW-1:0] value = source == 3'd1 ? values[0 +: C*VW]
                          : source == 3'd2 ? values[C*VW +: C*VW]
                          : source == 3'd3 ? values[2*C*VW +: C*VW]
                          : source == 3'd4 ? values[3*C*VW +: C*VW] : values[4*C*VW +: C*VW];
    wire [C*DW-1:0] corner = part == 2'd0 ? corners[2*C*DW +: C*DW]
                           : part == 2'd1 ? corners[C*DW +: C*DW] : corners[0 +: C*DW];
    wire [C*DW-1:0] rounded;

    genvar i;
    generate
        for (i = 0; i < C; i = i + 1) begin : g_round
            if (GUARD > 0) begin : g_guard
                wire [VW-1:0] half_up = value[i*VW +: VW] + (VW'(1) << (GUARD - 1));
                assign rounded[i*DW +: DW] = half_up[GUARD +: DW];
                wire unused_guard = &{1'b0, half_up[GUARD-1:0]};
            end else begin : g_plain
                assign rounded[i*DW +: DW] = value[i*VW +: DW];
            end
        end
    endgenerate

    assign data = is_corner ? corner : rounded;
endmodule

`default_nettype wire
