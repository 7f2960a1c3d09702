`default_nettype none

// The Surface Normal Variance Test (Doggett and Hirche 2000, sections 2.2 and 3.1.4): nt = 1 if
// some component of the normal at the midpoint differs from that at an end by more than the
// threshold, strictly.
//
// In world space the displaced normals N' are compared: six differences. In map space the map's
// normals N_D take their place in the same six, and six more compare the base normals N.
//
// Stage 1: absolute differences. Stage 2: comparisons, and their OR.
//
// Time: latency 2, one item a cycle, in_ready follows out_ready.
module normal_test #(
`include "rtl/units/normal_test_params.svh"
) (
    input  wire                                     clk,
    input  wire                                     rst_n,      // synchronous, low

    // Registers, stable while items are in the unit.
    input  wire        [DISPLACED_NORMAL_WIDTH-1:0] threshold,  // with the fraction bits of N'
    input  wire                                     map_space,  // compare N_D and N apart

    input  wire                                     in_valid,
    output wire                                     in_ready,
    input  wire                                     skip,       // decided: pass with nt = 0
    input  wire signed [DISPLACED_NORMAL_WIDTH-1:0] displaced_normal1_x,  // N', end 1
    input  wire signed [DISPLACED_NORMAL_WIDTH-1:0] displaced_normal1_y,
    input  wire signed [DISPLACED_NORMAL_WIDTH-1:0] displaced_normal1_z,
    input  wire signed [MAP_NORMAL_WIDTH-1:0]       map_normal1_x,        // N_D
    input  wire signed [MAP_NORMAL_WIDTH-1:0]       map_normal1_y,
    input  wire signed [MAP_NORMAL_WIDTH-1:0]       map_normal1_z,
    input  wire signed [NORMAL_WIDTH-1:0]           normal1_x,            // N
    input  wire signed [NORMAL_WIDTH-1:0]           normal1_y,
    input  wire signed [NORMAL_WIDTH-1:0]           normal1_z,
    input  wire signed [DISPLACED_NORMAL_WIDTH-1:0] displaced_normal2_x,  // end 2
    input  wire signed [DISPLACED_NORMAL_WIDTH-1:0] displaced_normal2_y,
    input  wire signed [DISPLACED_NORMAL_WIDTH-1:0] displaced_normal2_z,
    input  wire signed [MAP_NORMAL_WIDTH-1:0]       map_normal2_x,
    input  wire signed [MAP_NORMAL_WIDTH-1:0]       map_normal2_y,
    input  wire signed [MAP_NORMAL_WIDTH-1:0]       map_normal2_z,
    input  wire signed [NORMAL_WIDTH-1:0]           normal2_x,
    input  wire signed [NORMAL_WIDTH-1:0]           normal2_y,
    input  wire signed [NORMAL_WIDTH-1:0]           normal2_z,
    input  wire signed [DISPLACED_NORMAL_WIDTH-1:0] displaced_normal12_x,  // the midpoint
    input  wire signed [DISPLACED_NORMAL_WIDTH-1:0] displaced_normal12_y,
    input  wire signed [DISPLACED_NORMAL_WIDTH-1:0] displaced_normal12_z,
    input  wire signed [MAP_NORMAL_WIDTH-1:0]       map_normal12_x,
    input  wire signed [MAP_NORMAL_WIDTH-1:0]       map_normal12_y,
    input  wire signed [MAP_NORMAL_WIDTH-1:0]       map_normal12_z,
    input  wire signed [NORMAL_WIDTH-1:0]           normal12_x,
    input  wire signed [NORMAL_WIDTH-1:0]           normal12_y,
    input  wire signed [NORMAL_WIDTH-1:0]           normal12_z,

    output wire                                     out_valid,
    input  wire                                     out_ready,
    output wire                                     nt,         // some component differs
    output wire        [1:0]                        load        // enables of stages 1 and 2, the
                                                                // user's too
);
    localparam integer DW = DISPLACED_NORMAL_WIDTH;
    localparam integer MW = MAP_NORMAL_WIDTH;
    localparam integer BW = NORMAL_WIDTH;
    localparam integer SW = (DW > MW) ? DW : MW;  // a component of N', or of N_D in its place

    // The threshold in LSB of N_D and of N. A coarser N_D differs by multiples of its own LSB, so
    // dropping the threshold's low bits changes no decision; N is never coarser than N'.
    localparam integer MAP_RISE  = MAP_NORMAL_FRAC - DISPLACED_NORMAL_FRAC;
    localparam integer BASE_RISE = NORMAL_FRAC - DISPLACED_NORMAL_FRAC;
    localparam integer MAP_UP    = (MAP_RISE > 0) ? MAP_RISE : 0;
    localparam integer MAP_DOWN  = (MAP_RISE < 0) ? -MAP_RISE : 0;
    localparam integer STW       = (DW + MAP_UP > SW) ? DW + MAP_UP : SW;
    localparam integer BTW       = (DW + BASE_RISE > BW) ? DW + BASE_RISE : BW;

    wire [STW-1:0] own_threshold    = STW'(threshold);
    wire [STW-1:0] map_threshold    = (own_threshold << MAP_UP) >> MAP_DOWN;
    wire [STW-1:0] shared_threshold = map_space ? map_threshold : own_threshold;
    wire [BTW-1:0] base_threshold   = BTW'(threshold) << BASE_RISE;

    wire skipped;                          // the item at the output was skipped

    rp_pipe #(.W(1), .L(2)) stages (
        .clk      (clk),
        .rst_n    (rst_n),
        .in_valid (in_valid),
        .in_ready (in_ready),
        .in_data  (skip),
        .out_valid(out_valid),
        .out_ready(out_ready),
        .out_data (skipped),
        .load     (load)
    );

    // Components in the order x, y, z; vertices in the order end 1, end 2, midpoint.
    wire [9*DW-1:0] displaced = {
        displaced_normal12_z, displaced_normal12_y, displaced_normal12_x,
        displaced_normal2_z, displaced_normal2_y, displaced_normal2_x,
        displaced_normal1_z, displaced_normal1_y, displaced_normal1_x};
    wire [9*MW-1:0] map = {
        map_normal12_z, map_normal12_y, map_normal12_x,
        map_normal2_z, map_normal2_y, map_normal2_x,
        map_normal1_z, map_normal1_y, map_normal1_x};
    wire [9*BW-1:0] base = {
        normal12_z, normal12_y, normal12_x,
        normal2_z, normal2_y, normal2_x,
        normal1_z, normal1_y, normal1_x};
    wire [9*SW-1:0] shared;                // N' or N_D

    wire [5:0] shared_beyond;              // ends 1 and 2 against the midpoint
    wire [5:0] base_beyond;

    genvar k;
    generate
        for (k = 0; k < 9; k = k + 1) begin : g_select
            wire signed [DW-1:0] own    = displaced[k*DW +: DW];
            wire signed [MW-1:0] of_map = map[k*MW +: MW];
            wire signed [SW-1:0] own_s  = SW'(own);
            wire signed [SW-1:0] map_s  = SW'(of_map);
            assign shared[k*SW +: SW] = map_space ? map_s : own_s;
        end
        for (k = 0; k < 6; k = k + 1) begin : g_component
            normal_test_difference #(.W(SW), .TW(STW)) difference (
                .clk(clk), .load(load[0]),
                .a(shared[k*SW +: SW]), .b(shared[(6 + k%3)*SW +: SW]),
                .threshold(shared_threshold), .beyond(shared_beyond[k])
            );
            normal_test_difference #(.W(BW), .TW(BTW)) base_difference (
                .clk(clk), .load(load[0]),
                .a(base[k*BW +: BW]), .b(base[(6 + k%3)*BW +: BW]),
                .threshold(base_threshold), .beyond(base_beyond[k])
            );
        end
    endgenerate

    // Stage 2.
    reg differs;

    always_ff @(posedge clk) begin
        if (load[1]) differs <= (|shared_beyond) | (map_space & (|base_beyond));
    end

    assign nt = differs & ~skipped;
endmodule

`default_nettype wire
