`default_nettype none

// The squared length of a diagonal p - q: the difference is cast to the format `diagonal` (SC_TRN
// and SC_SAT: bits dropped at the bottom, clamped at the top), then squared.
//
// Stage 1: cast differences. Stage 2: squares. Their sum, not registered, belongs to the caller.
module split_length #(
    parameter integer PW    = 32,  // bits of a coordinate
    parameter integer SHIFT = 0,   // fraction bits dropped by the cast; below 0: gained
    parameter integer DW    = 30   // bits of a component of the diagonal
) (
    input  wire            clk,
    input  wire [1:0]      load,   // enables of both stages
    input  wire [3*PW-1:0] p,      // x in the low bits
    input  wire [3*PW-1:0] q,
    output wire [2*DW-1:0] length  // three squares of at most 2^(2 DW - 2) each
);
    // Room for a carry, for the bits gained, and for the comparison with the ends of DW bits.
    localparam integer GAINED  = (SHIFT < 0) ? -SHIFT : 0;
    localparam integer DROPPED = (SHIFT > 0) ? SHIFT : 0;
    localparam integer WIDE    = ((PW + GAINED > DW) ? PW + GAINED : DW) + 2;

    localparam signed [WIDE-1:0] HIGH = (WIDE'(1) <<< (DW - 1)) - WIDE'(1);

    wire [3*2*DW-1:0] squares;

    genvar k;
    generate
        for (k = 0; k < 3; k = k + 1) begin : g_component
            wire signed [PW-1:0]   from = q[k*PW +: PW];
            wire signed [PW-1:0]   to   = p[k*PW +: PW];
            wire signed [WIDE-1:0] wide = WIDE'(to) - WIDE'(from);
            wire signed [WIDE-1:0] cut  = (wide <<< GAINED) >>> DROPPED;
            reg  signed [DW-1:0]   d;
            reg         [2*DW-1:0] square;

            always_ff @(posedge clk) begin
                if (load[0]) d <= (cut > HIGH) ? HIGH[DW-1:0]
                                : (cut < ~HIGH) ? ~HIGH[DW-1:0]
                                : cut[DW-1:0];
                if (load[1]) square <= (2*DW)'(d) * (2*DW)'(d);
            end

            assign squares[k*2*DW +: 2*DW] = square;
        end
    endgenerate

    assign length = squares[0 +: 2*DW] + squares[2*DW +: 2*DW] + squares[4*DW +: 2*DW];
endmodule

`default_nettype wire
