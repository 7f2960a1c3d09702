`default_nettype none

// One axis of a height read: the places along it at which the map is read, as texel coordinates,
// brought onto the map and to its filter level; each coordinate once.
//
// Texel centres lie at +1/2, so between them the cell is found half a texel lower; the nearest
// texel is floor(U). Of a filter level, places are the ends of U +- reach, 2^finer spaces apart:
// with them U, and U +- reach / 2. Stage 1: places and weight. Stage 2: coordinates, with U within
// one period of a periodic map, or clamped to the border; then dropping `level` bits. Where a place
// of a footprint has a coordinate that another has before it, that one is read once.
module displace_cell #(
    parameter integer UV_WIDTH = 23,
    parameter integer UV_FRAC  = 8
) (
    input  wire                       clk,
    input  wire                       load,        // enable of stage 1
    input  wire                       load_item,   // enable of stage 2
    input  wire        [14:0]         size,        // of the map, texels
    input  wire                       wrap,
    input  wire        [1:0]          filter,
    input  wire        [1:0]          finer,       // looked at with the maximum
    input  wire signed [UV_WIDTH-1:0] u,
    input  wire signed [UV_WIDTH-1:0] reach,
    input  wire        [3:0]          level,       // with stage 2; 0 without filter levels
    output wire        [2:0]          count,       // with stage 2: coordinates to read, 1 to 5
    input  wire        [2:0]          number,      // behind it: which of them
    output wire        [13:0]         texel,       // its coordinate
    output wire        [UV_FRAC:0]    weight       // 2^UV_FRAC together if two are added
);
    // Wide enough for a texel beyond either end of U's range, and for twice a map's size.
    localparam integer XW = ((UV_WIDTH - UV_FRAC > 15) ? UV_WIDTH - UV_FRAC : 15) + 3;

    localparam integer MW = (UV_WIDTH + 1 > XW) ? UV_WIDTH + 1 : XW;

    localparam [UV_FRAC:0] ONE = (UV_FRAC+1)'(1) << UV_FRAC;

    wire                 bilinear = (filter == 2'd1);
    wire                 maximum  = (filter == 2'd2);
    wire                 average  = (filter == 2'd3);
    wire                 levels   = filter[1];
    wire signed [MW-1:0] wide     = MW'(u);
    wire signed [MW-1:0] one      = MW'($signed({1'b0, ONE}));
    wire signed [MW-1:0] to_end   = MW'(reach);
    wire signed [MW-1:0] halfway  = to_end >>> 1;
    wire signed [MW-1:0] first    = levels ? wide - to_end : bilinear ? wide - (one >>> 1) : wide;
    wire signed [MW-1:0] last     = levels ? wide + to_end : first + one;

    // Five places in the order of the map: the ends, halfway to them, the middle.
    wire [5*MW-1:0] places = {last, wide + halfway, wide, wide - halfway, first};
    wire [5*14-1:0] texels;

    genvar k;
    generate
        for (k = 0; k < 5; k = k + 1) begin : g_place
            wire signed [MW-1:0] place = $signed(places[k*MW +: MW]) >>> UV_FRAC;
            wire                 unused_top = &{1'b0, place};  // fewer bits than U
            reg  signed [XW-1:0] index;
            wire        [13:0]   at;

            always_ff @(posedge clk) begin
                if (load) index <= place[XW-1:0];
            end

            rp_map_coordinate #(.W(XW)) coordinate (
                .index(index), .size(size), .wrap(wrap), .at(at)
            );
            assign texels[k*14 +: 14] = at >> level;
        end
    endgenerate

    // Which of the five are looked at; of a footprint those whose coordinate is not there yet.
    wire [4:0] some   = (levels | bilinear) ? 5'b10001 : 5'b00001;
    wire [4:0] finest = {1'b1, finer[1], |finer, finer[1], 1'b1};
    wire [4:0] looked = maximum ? finest : some;

    function automatic [4:0] fresh(input [5*14-1:0] t, input [4:0] mask);
        logic [4:0] once;
        integer     i, j;
        begin
            once = mask;
            for (i = 1; i < 5; i = i + 1)
                for (j = 0; j < i; j = j + 1)
                    if (mask[j] && t[14*i +: 14] == t[14*j +: 14]) once[i] = 1'b0;
            fresh = once;
        end
    endfunction

    wire [4:0] to_read = bilinear ? looked : fresh(texels, looked);

    assign count = {2'd0, to_read[0]} + {2'd0, to_read[1]} + {2'd0, to_read[2]}
                 + {2'd0, to_read[3]} + {2'd0, to_read[4]};

    // Behind stage 2.
    reg [UV_FRAC:0]  fraction;             // of the last place; none without interpolation
    reg [5*14-1:0]   held;
    reg [4:0]        held_mask;
    reg [UV_FRAC:0]  first_weight, other_weight;

    always_ff @(posedge clk) begin
        if (load) fraction <= first[UV_FRAC:0] & (ONE - 1'b1) & {(UV_FRAC+1){bilinear}};
        if (load_item) begin
            held         <= texels;
            held_mask    <= to_read;
            first_weight <= (average & to_read[4]) ? ONE >> 1 : ONE - fraction;
            other_weight <= average ? ONE >> 1 : levels ? ONE : fraction;
        end
    end

    // The texel of that number: place 0 is always the first.
    function automatic [13:0] picked(input [5*14-1:0] t, input [4:0] mask, input [2:0] which);
        logic [2:0] passed;
        integer     i;
        begin
            passed = 3'd0;
            picked = t[13:0];
            for (i = 1; i < 5; i = i + 1)
                if (mask[i]) begin
                    passed = passed + 3'd1;
                    if (passed == which) picked = t[14*i +: 14];
                end
        end
    endfunction

    wire unused_mask = held_mask[0];

    assign texel  = picked(held, held_mask, number);
    assign weight = (number == 3'd0) ? first_weight : other_weight;
endmodule

`default_nettype wire
