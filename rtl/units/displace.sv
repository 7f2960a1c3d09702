`default_nettype none

// Displace Vertex (Doggett and Hirche 2000, equation 1 and section 3): P' = P + D(U) N, with the
// height of the nearest texel or of the four around U, interpolated, scaled to world units. Or, of
// a filter level, with the highest of the texels under a footprint, the lowest where the surface
// is seen from the back, or their average (Gumhold and Huettner 4.1).
//
// Stage 1: the places along each axis. Stage 2: a read a cycle, one to four, of a `finer` level up
// to 9 or 25, row by row. Stages 3 and 4 of the answers: weights; a vertex' answers become one in
// stage 5. Stage 6: the height. Stages 7 to 9: D. Stage 10: the products D * N. Stage 11: P + D N,
// cast.
//
// Time: with a memory that answers M cycles after a request, latency 12 + M, and R - 1 more with R
// reads; R cycles a vertex; in_ready depends on registers and on the memory alone.
module displace #(
`include "rtl/units/displace_params.svh"
) (
    input  wire                           clk,
    input  wire                           rst_n,           // synchronous, low

    // Registers, stable while vertices are in the unit.
    input  wire        [14:0]             map_width,       // texels
    input  wire        [14:0]             map_height,
    input  wire                           wrap,            // the map is periodic
    input  wire        [1:0]              filter,          // nearest, bilinear, maximum, average
    input  wire        [1:0]              finer,           // 2^finer + 1 places: maximum only
    input  wire                           minima,          // the levels have their own
    input  wire        [24:0]             scale_mantissa,  // D = h * mantissa * 2^-exponent + bias
    input  wire        [5:0]              scale_exponent,
    input  wire signed [DISPLACEMENT_WIDTH-1:0] bias,

    input  wire                           in_valid,
    output wire                           in_ready,
    input  wire signed [POSITION_WIDTH-1:0] p_x,           // P
    input  wire signed [POSITION_WIDTH-1:0] p_y,
    input  wire signed [POSITION_WIDTH-1:0] p_z,
    input  wire signed [NORMAL_WIDTH-1:0] n_x,             // N
    input  wire signed [NORMAL_WIDTH-1:0] n_y,
    input  wire signed [NORMAL_WIDTH-1:0] n_z,
    input  wire signed [UV_WIDTH-1:0]     u_x,             // within one period of the map
    input  wire signed [UV_WIDTH-1:0]     u_y,
    input  wire signed [UV_WIDTH-1:0]     reach_x,         // of a filter level: U +- reach
    input  wire signed [UV_WIDTH-1:0]     reach_y,
    input  wire        [3:0]              level,
    input  wire                           back,            // seen from the back: the lowest

    // The texel read port: requests, and answers in their order.
    output wire                           texel_valid,
    input  wire                           texel_ready,
    output wire        [13:0]             texel_x,         // in texels of the level
    output wire        [13:0]             texel_y,
    output wire        [3:0]              texel_level,
    output wire                           texel_minimum,   // of the level's minima
    input  wire                           texel_rvalid,
    output wire                           texel_rready,
    input  wire        [HEIGHT_WIDTH-1:0] texel_rdata,

    output wire                           out_valid,
    input  wire                           out_ready,
    output wire signed [POSITION_WIDTH-1:0] displaced_x,
    output wire signed [POSITION_WIDTH-1:0] displaced_y,
    output wire signed [POSITION_WIDTH-1:0] displaced_z
);
    localparam integer PW = POSITION_WIDTH;
    localparam integer NW = NORMAL_WIDTH;
    localparam integer DW = DISPLACEMENT_WIDTH;
    localparam integer VW = 3 * (PW + NW);         // P and N
    localparam integer RW = VW + 5;                // and the filter level, and the side seen
    localparam integer WW = UV_FRAC + 1;           // a weight

    localparam integer FILTER_BITS = FILTERED_HEIGHT_FRAC - HEIGHT_FRAC;
    localparam integer HW = (FILTERED_HEIGHT_WIDTH > HEIGHT_WIDTH + FILTER_BITS)
                          ? FILTERED_HEIGHT_WIDTH : HEIGHT_WIDTH + FILTER_BITS;
    localparam integer ALIGN = DISPLACEMENT_FRAC + NORMAL_FRAC - POSITION_FRAC;  // >= 0
    localparam integer TW = ((PW + ALIGN > DW + NW) ? PW + ALIGN : DW + NW) + 1;

    // Beats in flight: one a cycle while the memory answers within 6 cycles.
    localparam integer IN_FLIGHT = 8;

    // Stages 1 and 2.
    wire          levels = filter[1];
    wire          load_cell, load_item;
    wire          cell_valid, cell_ready;
    wire [RW-1:0] cell_vertex;
    wire          beat_valid, beat_ready, beat_last;
    wire [RW-1:0] beat_vertex;
    wire [4:0]    beat_j;
    wire [2:0]    columns, rows;                   // 1 to 5

    rp_pipe #(.W(RW), .L(1)) locating (
        .clk(clk), .rst_n(rst_n),
        .in_valid(in_valid), .in_ready(in_ready),
        .in_data({levels & back, {4{levels}} & level, p_z, p_y, p_x, n_z, n_y, n_x}),
        .out_valid(cell_valid), .out_ready(cell_ready), .out_data(cell_vertex),
        .load(load_cell)
    );
    rp_expand #(.W(RW), .NW(5)) reading (
        .clk(clk), .rst_n(rst_n),
        .in_valid(cell_valid), .in_ready(cell_ready), .in_data(cell_vertex),
        .in_n(5'(columns) * 5'(rows)),
        .out_valid(beat_valid), .out_ready(beat_ready), .out_data(beat_vertex),
        .out_j(beat_j), .out_last(beat_last), .load(load_item)
    );

    // Beats go along x first: beat j is that of column j mod columns, row j / columns.
    reg  [4:0]    row_beats;                       // columns of the vertex that is read
    wire [4:0]    two_rows   = {row_beats[3:0], 1'b0};
    wire [4:0]    three_rows = two_rows + row_beats;
    wire [4:0]    four_rows  = {row_beats[2:0], 2'b00};
    wire [2:0]    beat_row   = {2'd0, beat_j >= row_beats} + {2'd0, beat_j >= two_rows}
                             + {2'd0, beat_j >= three_rows} + {2'd0, beat_j >= four_rows};
    wire [4:0]    beat_column = beat_j - 5'(beat_row) * row_beats;
    wire          unused_column = &{1'b0, beat_column[4:3]};
    wire [WW-1:0] weight_x, weight_y;

    always_ff @(posedge clk) if (load_item) row_beats <= 5'(columns);

    displace_cell #(.UV_WIDTH(UV_WIDTH), .UV_FRAC(UV_FRAC)) column (
        .clk(clk), .load(load_cell), .load_item(load_item),
        .size(map_width), .wrap(wrap), .filter(filter), .finer(finer), .u(u_x), .reach(reach_x),
        .level(cell_vertex[VW +: 4]), .count(columns),
        .number(beat_column[2:0]), .texel(texel_x), .weight(weight_x)
    );
    displace_cell #(.UV_WIDTH(UV_WIDTH), .UV_FRAC(UV_FRAC)) row (
        .clk(clk), .load(load_cell), .load_item(load_item),
        .size(map_height), .wrap(wrap), .filter(filter), .finer(finer), .u(u_y), .reach(reach_y),
        .level(cell_vertex[VW +: 4]), .count(rows),
        .number(beat_row), .texel(texel_y), .weight(weight_y)
    );

    assign texel_level   = beat_vertex[VW +: 4];
    assign texel_minimum = minima & beat_vertex[VW + 4] & (beat_vertex[VW +: 4] != 4'd0);

    // The reads. Weights and vertex ride along with each beat.
    wire                    answer_valid, answer_ready, answer_first, answer_last;
    wire                    unused_read;
    wire [WW-1:0]           answer_weight_x, answer_weight_y;
    wire [RW-1:0]           answer_vertex;
    wire [HEIGHT_WIDTH-1:0] answer;

    rp_client #(.DW(HEIGHT_WIDTH), .TW(2 + 2 * WW + RW), .K(IN_FLIGHT)) reader (
        .clk(clk), .rst_n(rst_n),
        .in_valid(beat_valid), .in_ready(beat_ready), .in_read(1'b1),
        .in_tag({beat_j == 5'd0, beat_last, weight_x, weight_y, beat_vertex}),
        .mem_valid(texel_valid), .mem_ready(texel_ready),
        .mem_rvalid(texel_rvalid), .mem_rready(texel_rready), .mem_rdata(texel_rdata),
        .out_valid(answer_valid), .out_ready(answer_ready),
        .out_tag({answer_first, answer_last, answer_weight_x, answer_weight_y, answer_vertex}),
        .out_read(unused_read), .out_data(answer)
    );

    // Stages 3 and 4, beat by beat; stage 5 adds the beats up; 6 to 11, vertex by vertex.
    wire [1:0]    load_answer;
    wire          load_beat;
    wire [6:0]    load;
    wire          term_valid, term_ready, term_first, term_last;
    wire          sum_valid, sum_ready;
    wire [RW-1:0] term_vertex;
    wire          unused_level = &{1'b0, term_vertex[VW +: 4]};
    wire          unused_load = load[0];           // stage 5 takes every beat, not only the last
    wire          unused_out;

    rp_pipe #(.W(2 + RW), .L(2)) weighting (
        .clk(clk), .rst_n(rst_n),
        .in_valid(answer_valid), .in_ready(answer_ready),
        .in_data({answer_first, answer_last, answer_vertex}),
        .out_valid(term_valid), .out_ready(term_ready),
        .out_data({term_first, term_last, term_vertex}),
        .load(load_answer)
    );
    rp_collect adding (
        .in_valid(term_valid), .in_ready(term_ready), .in_last(term_last),
        .out_valid(sum_valid), .out_ready(sum_ready), .load(load_beat)
    );
    rp_pipe #(.W(1), .L(7)) stages (
        .clk(clk), .rst_n(rst_n),
        .in_valid(sum_valid), .in_ready(sum_ready), .in_data(1'b0),
        .out_valid(out_valid), .out_ready(out_ready), .out_data(unused_out),
        .load(load)
    );

    // P and N wait for D, from stage 5 to stage 9.
    wire [VW-1:0] vertex;

    rp_delay #(.W(VW), .L(5)) waiting (
        .clk(clk), .load(load[4:0]), .in_data(term_vertex[VW-1:0]), .out_data(vertex)
    );

    wire [HW-1:0]        height;
    wire signed [DW-1:0] d;

    displace_height #(
        .HEIGHT_WIDTH(HEIGHT_WIDTH), .UV_FRAC(UV_FRAC), .SHIFT(2 * UV_FRAC - FILTER_BITS),
        .FILTERED(FILTERED_HEIGHT_WIDTH), .OW(HW)
    ) joining (
        .clk(clk), .load(load_answer), .load_beat(load_beat), .load_height(load[1]),
        .filter(filter), .first(term_first), .back(term_vertex[VW + 4]), .texel(answer),
        .weight_x(answer_weight_x), .weight_y(answer_weight_y), .height(height)
    );
    displace_scale #(.HW(HW), .FRAC(DISPLACEMENT_FRAC - FILTER_BITS), .DW(DW)) scale (
        .clk(clk), .load(load[4:2]), .height(height),
        .mantissa(scale_mantissa), .exponent(scale_exponent), .bias(bias), .d(d)
    );

    // Stages 10 and 11.
    wire [3*PW-1:0] displaced;

    genvar k;
    generate
        for (k = 0; k < 3; k = k + 1) begin : g_component
            wire signed [NW-1:0] n = vertex[k*NW +: NW];
            wire signed [PW-1:0] p = vertex[3*NW + k*PW +: PW];
            reg  signed [TW-1:0] product;
            reg  signed [PW-1:0] position;
            reg  signed [PW-1:0] sum;
            wire signed [PW-1:0] limited;

            rp_cast #(.W(TW), .SHIFT(ALIGN), .OW(PW)) cast (
                .x((TW'(position) <<< ALIGN) + product), .y(limited)
            );

            always_ff @(posedge clk) begin
                if (load[5]) begin
                    product  <= TW'(d) * TW'(n);
                    position <= p;
                end
                if (load[6]) sum <= limited;
            end

            assign displaced[k*PW +: PW] = sum;
        end
    endgenerate

    assign {displaced_z, displaced_y, displaced_x} = displaced;
endmodule

`default_nettype wire
