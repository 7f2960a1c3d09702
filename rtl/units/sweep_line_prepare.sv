`default_nettype none

// What two lanes want to know of a base triangle before its first beat, so that no column, half or
// triangle starts with a bubble: each half's first edge point, each walk's first next Vbase, and
// the base's step where it also crosses a row. Combinational.
module sweep_line_prepare #(
    parameter integer C = 13,               // components
    parameter integer VW = 32,              // bits of a value
    parameter integer EXACT = 1
) (
    input  wire            moved0,          // the first point of the edge is not its start
    input  wire            moved1,
    input  wire [13:0]     steps0,          // of the edges
    input  wire [13:0]     steps1,
    input  wire [26:0]     determinant,
    input  wire            down,            // direction of the first walk
    input  wire            falls,           // its rows go down
    input  wire            crosses0,        // the first next Vbase is in another row
    input  wire            crosses1,
    input  wire [C*VW-1:0] start0, start1,  // of the edges
    input  wire [C*VW-1:0] step0, step1,
    input  wire [C*15-1:0] rest0, rest1,
    input  wire [C*VW-1:0] base0, base1,    // of the walks
    input  wire [C*VW-1:0] sweep_step,
    input  wire [C*27-1:0] sweep_rest,
    input  wire [C*VW-1:0] side_step,
    input  wire [C*27-1:0] side_rest,
    output wire [C*VW-1:0] edge0, edge1,    // first points
    output wire [C*15-1:0] edge0_rest, edge1_rest,
    output wire [C*VW-1:0] slant,           // Dsweep +- Dside
    output wire [C*27-1:0] slant_rest,
    output wire [C*VW-1:0] next0, next1,    // next Vbase
    output wire [C*27-1:0] next0_rest, next1_rest
);
    wire [27:0] area = {determinant, 1'b0};

    // Exact accumulators start with half a modulus.
    wire [C*15-1:0] half0 = (EXACT != 0) ? {C{1'b0, steps0}} : '0;
    wire [C*15-1:0] half1 = (EXACT != 0) ? {C{1'b0, steps1}} : '0;
    wire [C*27-1:0] half_area = (EXACT != 0) ? {C{determinant}} : '0;

    wire [C*VW-1:0] point0, point1;
    wire [C*15-1:0] point0_rest, point1_rest;

    sweep_line_adder #(.COMPONENTS(C), .VW(VW), .RW(15), .EXACT(EXACT)) to_point0 (
        .subtract(1'b0), .modulus({1'b0, steps0, 1'b0}), .a(start0), .a_rest(half0),
        .b(step0), .b_rest(rest0), .sum(point0), .sum_rest(point0_rest)
    );
    sweep_line_adder #(.COMPONENTS(C), .VW(VW), .RW(15), .EXACT(EXACT)) to_point1 (
        .subtract(1'b0), .modulus({1'b0, steps1, 1'b0}), .a(start1), .a_rest(half1),
        .b(step1), .b_rest(rest1), .sum(point1), .sum_rest(point1_rest)
    );
    assign edge0      = moved0 ? point0 : start0;
    assign edge1      = moved1 ? point1 : start1;
    assign edge0_rest = moved0 ? point0_rest : half0;
    assign edge1_rest = moved1 ? point1_rest : half1;

    // In decreasing direction Dsweep is taken away, and so is the slant: its Dside turns round.
    sweep_line_adder #(.COMPONENTS(C), .VW(VW), .RW(27), .EXACT(EXACT)) to_slant (
        .subtract(down ^ falls), .modulus(area), .a(sweep_step), .a_rest(sweep_rest),
        .b(side_step), .b_rest(side_rest), .sum(slant), .sum_rest(slant_rest)
    );
    sweep_line_adder #(.COMPONENTS(C), .VW(VW), .RW(27), .EXACT(EXACT)) to_next0 (
        .subtract(down), .modulus(area), .a(base0), .a_rest(half_area),
        .b(crosses0 ? slant : sweep_step), .b_rest(crosses0 ? slant_rest : sweep_rest),
        .sum(next0), .sum_rest(next0_rest)
    );
    // The second walk, of a roof, comes from the other end.
    sweep_line_adder #(.COMPONENTS(C), .VW(VW), .RW(27), .EXACT(EXACT)) to_next1 (
        .subtract(1'b1), .modulus(area), .a(base1), .a_rest(half_area),
        .b(crosses1 ? slant : sweep_step), .b_rest(crosses1 ? slant_rest : sweep_rest),
        .sum(next1), .sum_rest(next1_rest)
    );
endmodule

`default_nettype wire
