`default_nettype none

// The Tessellation Tests (Doggett and Hirche 2000, section 3.1, figure 8): an edge with the vertex
// that would split it comes in, the decision goes out.
//
//   texcoord_test -> view_test -> normal_test -> rp_beside -> split = eligible & ct & vt
//       ct               vt            nt        height_test           & (nt | sht)
//                                                    sht
//
// The tests stand in a row, the cheap ones first, and edges keep their order. An edge is decided
// when it may not be split at all, or when ct or vt has said no; the flag for that travels with it,
// and later tests let it pass. When nt has said yes, sht has nothing to add. A skipped edge reads
// nothing from the summed-area table. `eager` turns that off; the decision is the same.
//
// A test that is not used is skipped by every edge, and its result is neutral (ct = vt = 1,
// nt = sht = 0); with neither nt nor sht every edge counts as detailed.
//
// Time, with memory latency 1 and no seam crossed: latency 18, or 14 if sht is skipped; an edge
// that reads takes 4 cycles, any other 1; 15 edges inside that read, or 21 that do not.
module tessellation_tests #(
`include "rtl/tops/tessellation_tests_params.svh"
) (
    input  wire                                     clk,
    input  wire                                     rst_n,      // synchronous, low

    // Registers, stable while edges are inside: see the units.
    input  wire                                     eager,             // skip nothing
    input  wire                                     use_view_test,     // the scene has this test
    input  wire                                     use_normal_test,
    input  wire                                     use_height_test,
    input  wire        [SCREEN_WIDTH:0]             view_threshold,
    input  wire        [DISPLACED_NORMAL_WIDTH-1:0] normal_threshold,
    input  wire                                     map_space,
    input  wire        [12:0]                       map_width,
    input  wire        [12:0]                       map_height,
    input  wire                                     wrap,
    input  wire                                     literal,
    input  wire                                     sum,
    input  wire        [SAT_WIDTH-1:0]              height_threshold,

    input  wire                                     in_valid,
    output wire                                     in_ready,
    input  wire                                     eligible,   // below the cap, not known unsplit
    input  wire signed [UV_WIDTH-1:0]               u1_x,       // end 1, in texels
    input  wire signed [UV_WIDTH-1:0]               u1_y,
    input  wire signed [UV_WIDTH-1:0]               u2_x,       // end 2
    input  wire signed [UV_WIDTH-1:0]               u2_y,
    input  wire signed [UV_WIDTH-1:0]               u12_x,      // the new vertex
    input  wire signed [UV_WIDTH-1:0]               u12_y,
    input  wire                                     near1,      // P' on the screen, end 1
    input  wire signed [SCREEN_WIDTH-1:0]           x1,
    input  wire signed [SCREEN_WIDTH-1:0]           y1,
    input  wire                                     near2,      // end 2
    input  wire signed [SCREEN_WIDTH-1:0]           x2,
    input  wire signed [SCREEN_WIDTH-1:0]           y2,
    input  wire signed [DISPLACED_NORMAL_WIDTH-1:0] displaced_normal1_x,    // N', end 1
    input  wire signed [DISPLACED_NORMAL_WIDTH-1:0] displaced_normal1_y,
    input  wire signed [DISPLACED_NORMAL_WIDTH-1:0] displaced_normal1_z,
    input  wire signed [MAP_NORMAL_WIDTH-1:0]       map_normal1_x,          // N_D, end 1
    input  wire signed [MAP_NORMAL_WIDTH-1:0]       map_normal1_y,
    input  wire signed [MAP_NORMAL_WIDTH-1:0]       map_normal1_z,
    input  wire signed [NORMAL_WIDTH-1:0]           normal1_x,              // N, end 1
    input  wire signed [NORMAL_WIDTH-1:0]           normal1_y,
    input  wire signed [NORMAL_WIDTH-1:0]           normal1_z,
    input  wire signed [DISPLACED_NORMAL_WIDTH-1:0] displaced_normal2_x,    // N', end 2
    input  wire signed [DISPLACED_NORMAL_WIDTH-1:0] displaced_normal2_y,
    input  wire signed [DISPLACED_NORMAL_WIDTH-1:0] displaced_normal2_z,
    input  wire signed [MAP_NORMAL_WIDTH-1:0]       map_normal2_x,          // N_D, end 2
    input  wire signed [MAP_NORMAL_WIDTH-1:0]       map_normal2_y,
    input  wire signed [MAP_NORMAL_WIDTH-1:0]       map_normal2_z,
    input  wire signed [NORMAL_WIDTH-1:0]           normal2_x,              // N, end 2
    input  wire signed [NORMAL_WIDTH-1:0]           normal2_y,
    input  wire signed [NORMAL_WIDTH-1:0]           normal2_z,
    input  wire signed [DISPLACED_NORMAL_WIDTH-1:0] displaced_normal12_x,   // N', the new vertex
    input  wire signed [DISPLACED_NORMAL_WIDTH-1:0] displaced_normal12_y,
    input  wire signed [DISPLACED_NORMAL_WIDTH-1:0] displaced_normal12_z,
    input  wire signed [MAP_NORMAL_WIDTH-1:0]       map_normal12_x,         // N_D, the new vertex
    input  wire signed [MAP_NORMAL_WIDTH-1:0]       map_normal12_y,
    input  wire signed [MAP_NORMAL_WIDTH-1:0]       map_normal12_z,
    input  wire signed [NORMAL_WIDTH-1:0]           normal12_x,             // N, the new vertex
    input  wire signed [NORMAL_WIDTH-1:0]           normal12_y,
    input  wire signed [NORMAL_WIDTH-1:0]           normal12_z,

    // The read port of the summed-area table: see height_test.
    output wire                                     sat_valid,
    input  wire                                     sat_ready,
    output wire        [2:0]                        sat_read,
    output wire        [3*13-1:0]                   sat_x,
    output wire        [3*13-1:0]                   sat_y,
    input  wire                                     sat_rvalid,
    output wire                                     sat_rready,
    input  wire        [3*SAT_WIDTH-1:0]            sat_rdata,

    output wire                                     out_valid,
    input  wire                                     out_ready,
    output wire                                     split,      // the decision
    output wire                                     ct,         // 1 also if skipped
    output wire                                     vt,
    output wire                                     nt,         // 0 also if skipped
    output wire                                     sht
);
    localparam integer UW = 6 * UV_WIDTH;
    localparam integer VW = 2 + 4 * SCREEN_WIDTH;
    localparam integer NW = 9 * (DISPLACED_NORMAL_WIDTH + MAP_NORMAL_WIDTH + NORMAL_WIDTH);

    // Edges that height_test holds at most: 3 stages, one at the reads, 8 beats, 4 stages.
    localparam integer INSIDE = 16;

    wire [UW-1:0] u = {u1_x, u1_y, u2_x, u2_y, u12_x, u12_y};
    wire [VW-1:0] screen = {near1, x1, y1, near2, x2, y2};
    wire [NW-1:0] normals = {
        displaced_normal1_x, displaced_normal1_y, displaced_normal1_z, map_normal1_x, map_normal1_y,
        map_normal1_z, normal1_x, normal1_y, normal1_z, displaced_normal2_x, displaced_normal2_y,
        displaced_normal2_z, map_normal2_x, map_normal2_y, map_normal2_z, normal2_x, normal2_y,
        normal2_z, displaced_normal12_x, displaced_normal12_y, displaced_normal12_z, map_normal12_x,
        map_normal12_y, map_normal12_z, normal12_x, normal12_y, normal12_z
    };

    // ---- Tex Coord Test -------------------------------------------------------------------------
    wire          ct_skip = ~eligible & ~eager;
    wire          ct_load, ct_valid, ct_ready, ct_says;
    wire          ct_eligible, ct_skipped;
    wire [UW-1:0] ct_u;
    wire [VW-1:0] ct_screen;
    wire [NW-1:0] ct_normals;

    texcoord_test #(.UV_WIDTH(UV_WIDTH), .UV_FRAC(UV_FRAC)) texcoord (
        .clk(clk), .rst_n(rst_n),
        .in_valid(in_valid), .in_ready(in_ready), .skip(ct_skip),
        .u1_x(u1_x), .u1_y(u1_y), .u2_x(u2_x), .u2_y(u2_y), .u12_x(u12_x), .u12_y(u12_y),
        .out_valid(ct_valid), .out_ready(ct_ready), .ct(ct_says), .load(ct_load)
    );
    rp_delay #(.W(2 + UW + VW + NW), .L(1)) past_texcoord (
        .clk(clk), .load(ct_load),
        .in_data({eligible, ct_skip, u, screen, normals}),
        .out_data({ct_eligible, ct_skipped, ct_u, ct_screen, ct_normals})
    );

    // ---- View Test ------------------------------------------------------------------------------
    wire          ct_open = ct_eligible & (ct_says | ct_skipped);  // undecided after it
    wire          vt_skip = ~use_view_test | (~ct_open & ~eager);
    wire [1:0]    vt_load;
    wire          vt_valid, vt_ready, vt_says;
    wire          vt_eligible, vt_ct, vt_skipped;
    wire [UW-1:0] vt_u;
    wire [NW-1:0] vt_normals;

    wire                           view_near1, view_near2;
    wire signed [SCREEN_WIDTH-1:0] view_x1, view_y1, view_x2, view_y2;
    assign {view_near1, view_x1, view_y1, view_near2, view_x2, view_y2} = ct_screen;

    view_test #(.SCREEN_WIDTH(SCREEN_WIDTH), .SCREEN_FRAC(SCREEN_FRAC)) view (
        .clk(clk), .rst_n(rst_n), .threshold(view_threshold),
        .in_valid(ct_valid), .in_ready(ct_ready), .skip(vt_skip),
        .near1(view_near1), .x1(view_x1), .y1(view_y1),
        .near2(view_near2), .x2(view_x2), .y2(view_y2),
        .out_valid(vt_valid), .out_ready(vt_ready), .vt(vt_says), .load(vt_load)
    );
    rp_delay #(.W(3 + UW + NW), .L(2)) past_view (
        .clk(clk), .load(vt_load),
        .in_data({ct_eligible, ct_says | ct_skipped, vt_skip, ct_u, ct_normals}),
        .out_data({vt_eligible, vt_ct, vt_skipped, vt_u, vt_normals})
    );

    // ---- Normal Test ----------------------------------------------------------------------------
    wire          vt_open = vt_eligible & vt_ct & (vt_says | vt_skipped);
    wire          nt_skip = ~use_normal_test | (~vt_open & ~eager);
    wire [1:0]    nt_load;
    wire          nt_valid, nt_ready, nt_says;
    wire          nt_eligible, nt_ct, nt_vt;
    wire [UW-1:0] nt_u;

    wire signed [DISPLACED_NORMAL_WIDTH-1:0]
        bent1_x, bent1_y, bent1_z, bent2_x, bent2_y, bent2_z, bent12_x, bent12_y, bent12_z;
    wire signed [MAP_NORMAL_WIDTH-1:0]
        map1_x, map1_y, map1_z, map2_x, map2_y, map2_z, map12_x, map12_y, map12_z;
    wire signed [NORMAL_WIDTH-1:0]
        base1_x, base1_y, base1_z, base2_x, base2_y, base2_z, base12_x, base12_y, base12_z;
    assign {
        bent1_x, bent1_y, bent1_z, map1_x, map1_y, map1_z, base1_x, base1_y, base1_z, bent2_x,
        bent2_y, bent2_z, map2_x, map2_y, map2_z, base2_x, base2_y, base2_z, bent12_x, bent12_y,
        bent12_z, map12_x, map12_y, map12_z, base12_x, base12_y, base12_z
    } = vt_normals;

    normal_test #(
        .DISPLACED_NORMAL_WIDTH(DISPLACED_NORMAL_WIDTH),
        .DISPLACED_NORMAL_FRAC(DISPLACED_NORMAL_FRAC),
        .MAP_NORMAL_WIDTH(MAP_NORMAL_WIDTH), .MAP_NORMAL_FRAC(MAP_NORMAL_FRAC),
        .NORMAL_WIDTH(NORMAL_WIDTH), .NORMAL_FRAC(NORMAL_FRAC)
    ) normal (
        .clk(clk), .rst_n(rst_n), .threshold(normal_threshold), .map_space(map_space),
        .in_valid(vt_valid), .in_ready(vt_ready), .skip(nt_skip),
        .displaced_normal1_x(bent1_x), .displaced_normal1_y(bent1_y), .displaced_normal1_z(bent1_z),
        .map_normal1_x(map1_x), .map_normal1_y(map1_y), .map_normal1_z(map1_z), .normal1_x(base1_x),
        .normal1_y(base1_y), .normal1_z(base1_z), .displaced_normal2_x(bent2_x),
        .displaced_normal2_y(bent2_y), .displaced_normal2_z(bent2_z), .map_normal2_x(map2_x),
        .map_normal2_y(map2_y), .map_normal2_z(map2_z), .normal2_x(base2_x), .normal2_y(base2_y),
        .normal2_z(base2_z), .displaced_normal12_x(bent12_x), .displaced_normal12_y(bent12_y),
        .displaced_normal12_z(bent12_z), .map_normal12_x(map12_x), .map_normal12_y(map12_y),
        .map_normal12_z(map12_z), .normal12_x(base12_x), .normal12_y(base12_y),
        .normal12_z(base12_z),
        .out_valid(nt_valid), .out_ready(nt_ready), .nt(nt_says), .load(nt_load)
    );
    rp_delay #(.W(3 + UW), .L(2)) past_normal (
        .clk(clk), .load(nt_load),
        .in_data({vt_eligible, vt_ct, vt_says | vt_skipped, vt_u}),
        .out_data({nt_eligible, nt_ct, nt_vt, nt_u})
    );

    // ---- Summed Height Test ---------------------------------------------------------------------
    wire nt_open  = nt_eligible & nt_ct & nt_vt & ~nt_says;
    wire sht_skip = ~use_height_test | (~nt_open & ~eager);
    wire sht_valid, sht_ready, done_valid, done_ready;
    wire out_eligible;

    wire signed [UV_WIDTH-1:0] at1_x, at1_y, at2_x, at2_y, at12_x, at12_y;
    assign {at1_x, at1_y, at2_x, at2_y, at12_x, at12_y} = nt_u;

    height_test #(
        .UV_WIDTH(UV_WIDTH), .UV_FRAC(UV_FRAC), .SAT_WIDTH(SAT_WIDTH), .HEIGHT_WIDTH(HEIGHT_WIDTH)
    ) height (
        .clk(clk), .rst_n(rst_n),
        .map_width(map_width), .map_height(map_height), .wrap(wrap), .literal(literal),
        .sum(sum), .threshold(height_threshold),
        .in_valid(sht_valid), .in_ready(sht_ready), .skip(sht_skip),
        .u1_x(at1_x), .u1_y(at1_y), .u2_x(at2_x), .u2_y(at2_y), .u12_x(at12_x), .u12_y(at12_y),
        .sat_valid(sat_valid), .sat_ready(sat_ready), .sat_read(sat_read), .sat_x(sat_x),
        .sat_y(sat_y), .sat_rvalid(sat_rvalid), .sat_rready(sat_rready), .sat_rdata(sat_rdata),
        .out_valid(done_valid), .out_ready(done_ready), .sht(sht)
    );
    rp_beside #(.W(4), .D(INSIDE)) past_height (
        .clk(clk), .rst_n(rst_n),
        .in_valid(nt_valid), .in_ready(nt_ready), .in_data({nt_eligible, nt_ct, nt_vt, nt_says}),
        .unit_valid(sht_valid), .unit_ready(sht_ready),
        .done_valid(done_valid), .done_ready(done_ready),
        .out_valid(out_valid), .out_ready(out_ready), .out_data({out_eligible, ct, vt, nt})
    );

    // ---- Pass or Tessellate ---------------------------------------------------------------------
    assign split = out_eligible & ct & vt & (nt | sht | ~(use_normal_test | use_height_test));
endmodule

`default_nettype wire
