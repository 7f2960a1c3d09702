`default_nettype none

// Filter level access (Gumhold and Huettner 4.1): which texels of which filter level a new vertex
// stands for, a rectangle U +- reach; and whether the surface is seen from the back there.
//
// Stages 0 to 9: half steps of two differences along both axes (footprint_step), beside 1/c.
// Stage 10: the rectangle around them; on an edge, which has one step, the square around that; at a
// corner nothing. Stage 11: the level, whose texels are no smaller than the longer side, or `finer`
// levels below it, and the limit of the reach, one texel less than the map.
//
// Beside them, (P - eye) . N: differences in stage 0, products in stage 1, the sum's sign in
// stage 2.
//
// Time: latency 12, one vertex a cycle, in_ready follows out_ready.
module footprint #(
`include "rtl/units/footprint_params.svh"
) (
    input  wire                               clk,
    input  wire                               rst_n,       // synchronous, low

    // Registers, stable while vertices are in the unit.
    input  wire        [14:0]                 map_width,   // texels
    input  wire        [14:0]                 map_height,
    input  wire        [3:0]                  last_level,
    input  wire        [1:0]                  finer,       // levels below that of the footprint
    input  wire signed [POSITION_WIDTH-1:0]   eye_x,
    input  wire signed [POSITION_WIDTH-1:0]   eye_y,
    input  wire signed [POSITION_WIDTH-1:0]   eye_z,

    input  wire                               in_valid,
    output wire                               in_ready,
    input  wire        [1:0]                  kind,        // 0 corner, 1 on an edge, 2 inside
    input  wire signed [POSITION_WIDTH-1:0]   p_x,         // P
    input  wire signed [POSITION_WIDTH-1:0]   p_y,
    input  wire signed [POSITION_WIDTH-1:0]   p_z,
    input  wire signed [NORMAL_WIDTH-1:0]     n_x,         // N
    input  wire signed [NORMAL_WIDTH-1:0]     n_y,
    input  wire signed [NORMAL_WIDTH-1:0]     n_z,
    input  wire signed [UV_WIDTH-1:0]         u_x,         // U
    input  wire signed [UV_WIDTH-1:0]         u_y,
    input  wire signed [INVERSE_W_WIDTH-1:0]  c,
    input  wire signed [SWEEP_DATA_WIDTH-1:0] step0_u,     // of the edge, or of the sweep
    input  wire signed [SWEEP_DATA_WIDTH-1:0] step0_v,
    input  wire signed [INVERSE_W_WIDTH-1:0]  step0_c,
    input  wire signed [SWEEP_DATA_WIDTH-1:0] step1_u,     // of the side
    input  wire signed [SWEEP_DATA_WIDTH-1:0] step1_v,
    input  wire signed [INVERSE_W_WIDTH-1:0]  step1_c,

    output wire                               out_valid,
    input  wire                               out_ready,
    output wire signed [UV_WIDTH-1:0]         reach_x,     // 0 and up
    output wire signed [UV_WIDTH-1:0]         reach_y,
    output wire        [3:0]                  level,
    output wire                               back         // seen from the back
);
    localparam integer XW = INVERSE_W_WIDTH - 1;           // a positive c without its sign
    localparam integer RW = UV_WIDTH + 1;                  // a sum of two halves
    localparam integer MW = ((RW > 15 + UV_FRAC) ? RW : 15 + UV_FRAC) + 1;

    wire [11:0] load;
    wire [1:0]  kind9;                                     // behind stage 9
    wire        unused_out;

    rp_pipe #(.W(1), .L(12)) stages (
        .clk(clk), .rst_n(rst_n),
        .in_valid(in_valid), .in_ready(in_ready), .in_data(1'b0),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(unused_out), .load(load)
    );
    rp_delay #(.W(2), .L(10)) kinds (
        .clk(clk), .load(load[9:0]), .in_data(kind), .out_data(kind9)
    );

    // Stages 0 to 7: 1/c, a c that is not positive being taken as the least positive one.
    wire [XW-1:0]              divisor = (c <= 0) ? XW'(1) : c[XW-1:0];
    wire [RECIPROCAL_BITS-1:0] mantissa;
    wire [5:0]                 exponent;

    rp_reciprocal #(
        .W(XW), .INDEX_BITS(RECIPROCAL_INDEX_BITS), .NEWTON_STEPS(RECIPROCAL_NEWTON_STEPS),
        .BITS(RECIPROCAL_BITS)
    ) reciprocal (
        .clk(clk), .load(load[7:0]), .x(divisor), .mantissa(mantissa), .exponent(exponent)
    );

    // Stages 0 to 9: half steps, in the order u and v of step 0, u and v of step 1.
    wire [4*SWEEP_DATA_WIDTH-1:0] steps = {step1_v, step1_u, step0_v, step0_u};
    wire [4*UV_WIDTH-1:0]         halves;

    genvar k;
    generate
        for (k = 0; k < 4; k = k + 1) begin : g_half
            footprint_step #(
                .UV_WIDTH(UV_WIDTH), .UV_FRAC(UV_FRAC),
                .DW(SWEEP_DATA_WIDTH), .DATA_FRAC(SWEEP_DATA_FRAC),
                .CW(INVERSE_W_WIDTH), .C_FRAC(INVERSE_W_FRAC), .BITS(RECIPROCAL_BITS)
            ) half_step (
                .clk(clk), .load(load[9:0]), .u((k % 2 == 0) ? u_x : u_y),
                .step(steps[k*SWEEP_DATA_WIDTH +: SWEEP_DATA_WIDTH]),
                .step_c((k < 2) ? step0_c : step1_c),
                .mantissa(mantissa), .exponent(exponent), .half(halves[k*UV_WIDTH +: UV_WIDTH])
            );
        end
    endgenerate

    // Stage 10.
    wire [UV_WIDTH-1:0] first_x  = halves[0 +: UV_WIDTH];
    wire [UV_WIDTH-1:0] first_y  = halves[UV_WIDTH +: UV_WIDTH];
    wire [UV_WIDTH-1:0] second_x = halves[2*UV_WIDTH +: UV_WIDTH];
    wire [UV_WIDTH-1:0] second_y = halves[3*UV_WIDTH +: UV_WIDTH];
    wire [UV_WIDTH-1:0] square   = (first_x > first_y) ? first_x : first_y;
    reg  [RW-1:0]       side_x, side_y;

    always_ff @(posedge clk) begin
        if (load[10]) begin
            case (kind9)
                2'd0: begin
                    side_x <= '0;
                    side_y <= '0;
                end
                2'd1: begin
                    side_x <= RW'(square);
                    side_y <= RW'(square);
                end
                default: begin
                    side_x <= RW'(first_x) + RW'(second_x);
                    side_y <= RW'(first_y) + RW'(second_y);
                end
            endcase
        end
    end

    // Stage 11. The level is the number of bits that twice the reach, less one, has above its
    // fraction.
    wire [RW-1:0] longer = (side_x > side_y) ? side_x : side_y;
    wire [RW:0]   least  = (longer == '0) ? '0 : {longer, 1'b0} - 1'b1;
    wire [RW:0]   whole  = least >> UV_FRAC;

    function automatic [5:0] length(input [RW:0] x);
        integer i;
        length = 6'd0;
        for (i = 0; i <= RW; i = i + 1) if (x[i]) length = 6'(i + 1);
    endfunction

    // What is kept fits the format of U, as every map that has its U in it.
    function automatic [UV_WIDTH-1:0] limited(input [RW-1:0] side, input [14:0] size);
        logic [MW-1:0] most;
        begin
            most    = (MW'(size) - MW'(1)) << UV_FRAC;
            limited = (MW'(side) < most) ? UV_WIDTH'(side) : UV_WIDTH'(most);
        end
    endfunction

    wire [5:0]          coarse = length(whole);
    wire [5:0]          wanted = (coarse > 6'(finer)) ? coarse - 6'(finer) : 6'd0;
    reg  [UV_WIDTH-1:0] kept_x, kept_y;
    reg  [3:0]          kept_level;

    always_ff @(posedge clk) begin
        if (load[11]) begin
            kept_x     <= limited(side_x, map_width);
            kept_y     <= limited(side_y, map_height);
            kept_level <= (wanted < 6'(last_level)) ? wanted[3:0] : last_level;
        end
    end

    assign reach_x = kept_x;
    assign reach_y = kept_y;
    assign level   = kept_level;

    // Seen from the back: an exact sum of three products.
    localparam integer EW = POSITION_WIDTH + 1;
    localparam integer TW = EW + NORMAL_WIDTH;

    wire [3*POSITION_WIDTH-1:0] position = {p_z, p_y, p_x};
    wire [3*POSITION_WIDTH-1:0] eye      = {eye_z, eye_y, eye_x};
    wire [3*NORMAL_WIDTH-1:0]   normal   = {n_z, n_y, n_x};
    wire [3*TW-1:0]             products;

    generate
        for (k = 0; k < 3; k = k + 1) begin : g_along
            wire signed [POSITION_WIDTH-1:0] p = position[k*POSITION_WIDTH +: POSITION_WIDTH];
            wire signed [POSITION_WIDTH-1:0] e = eye[k*POSITION_WIDTH +: POSITION_WIDTH];
            reg  signed [EW-1:0]             from_eye;
            reg  signed [NORMAL_WIDTH-1:0]   n;
            reg  signed [TW-1:0]             product;

            always_ff @(posedge clk) begin
                if (load[0]) begin
                    from_eye <= EW'(p) - EW'(e);
                    n        <= normal[k*NORMAL_WIDTH +: NORMAL_WIDTH];
                end
                if (load[1]) product <= TW'(from_eye) * TW'(n);
            end

            assign products[k*TW +: TW] = product;
        end
    endgenerate

    wire signed [TW+1:0] along = (TW+2)'($signed(products[0 +: TW]))
                               + (TW+2)'($signed(products[TW +: TW]))
                               + (TW+2)'($signed(products[2*TW +: TW]));

    rp_delay #(.W(1), .L(10)) sign (
        .clk(clk), .load(load[11:2]), .in_data(along > 0), .out_data(back)
    );
endmodule

`default_nettype wire
