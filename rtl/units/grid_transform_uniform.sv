`default_nettype none

// z_grid from the paper's lookup array: 2^INDEX_BITS intervals, uniform in w, interpolated
// linearly. It is made for one camera and written again for the next. Six register stages, enabled
// by the unit's `load`.
module grid_transform_uniform #(
    parameter integer CW         = 32,  // bits of w
    parameter integer INDEX_BITS = 6
) (
    input  wire                  clk,
    input  wire [5:0]            load,
    input  wire signed [CW-1:0]  table_near,         // w at word 0
    input  wire [19:0]           table_scale,  // intervals per LSB of w, times 2^(16 + table_shift)
    input  wire [5:0]            table_shift,
    input  wire                  table_write,
    input  wire [INDEX_BITS:0]   table_address,
    input  wire [21:0]           table_data,   // u14.8
    input  wire signed [CW-1:0]  w,            // > 0
    output wire signed [21:0]    z             // s15.6
);
    localparam integer PLACE = INDEX_BITS + 16;     // bits of a place: interval, and 16 within it
    localparam integer PW    = ((CW + 21 > PLACE) ? CW + 21 : PLACE) + 2;
    localparam signed [PW-1:0] LAST = (PW'(1) <<< PLACE) - PW'(1);

    reg [21:0] words [0:(1 << INDEX_BITS)];         // one more than there are intervals

    always_ff @(posedge clk) if (table_write) words[table_address] <= table_data;

    // Stages 0 and 1: the place, cut to the table at both ends.
    reg signed [CW:0]      offset;
    wire signed [PW-1:0]   product = PW'(offset) * $signed(PW'(table_scale));
    wire signed [PW-1:0]   scaled  = product >>> table_shift;
    reg [PLACE-1:0]        at;

    always_ff @(posedge clk) begin
        if (load[0]) offset <= (CW+1)'(w) - (CW+1)'(table_near);
        if (load[1])
            at <= (scaled > LAST) ? {PLACE{1'b1}} : scaled[PW-1] ? {PLACE{1'b0}} : scaled[PLACE-1:0];
    end

    // Stage 2: both ends of the interval.
    wire [INDEX_BITS:0] index = {1'b0, at[PLACE-1:16]};
    reg  [21:0]         low, high;
    reg  [15:0]         fraction;

    // Stages 3 to 5: low + (high - low) * fraction, 24 fraction bits, to the grid.
    reg  [37:0]         risen;                      // high >= low
    reg  [21:0]         low3;
    reg  signed [38:0]  sum;
    wire signed [21:0]  rounded;
    reg  signed [21:0]  z5;

    rp_cast #(.W(39), .SHIFT(18), .OW(22)) to_grid (.x(sum), .y(rounded));

    always_ff @(posedge clk) begin
        if (load[2]) begin
            low      <= words[index];
            high     <= words[index + (INDEX_BITS+1)'(1)];
            fraction <= at[15:0];
        end
        if (load[3]) begin
            risen <= (38'(high) - 38'(low)) * 38'(fraction);
            low3  <= low;
        end
        if (load[4]) sum <= $signed({1'b0, low3, 16'd0}) + $signed({1'b0, risen});
        if (load[5]) z5  <= rounded;
    end

    assign z = z5;
endmodule

`default_nettype wire
