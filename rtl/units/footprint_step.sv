`default_nettype none

// Half a step of the walk along one axis of the map, each way: |D - U D_c| / (2 c), where D and D_c
// are the changes of U c and c over a step (Gumhold and Huettner 4.1).
//
// Stage 0: U D_c. Stage 1: its cast to the format of D. Stage 2: the difference, saturated. Stages
// 3 to 7 wait for 1/c. Stages 8 and 9: times 1/c; half a step is a step with one more fraction bit.
module footprint_step #(
    parameter integer UV_WIDTH  = 23,
    parameter integer UV_FRAC   = 8,
    parameter integer DW        = 32,  // bits of D
    parameter integer DATA_FRAC = 16,
    parameter integer CW        = 32,  // bits of D_c
    parameter integer C_FRAC    = 30,
    parameter integer BITS      = 24   // of the mantissa of 1/c
) (
    input  wire                       clk,
    input  wire [9:0]                 load,      // stage enables
    input  wire signed [UV_WIDTH-1:0] u,         // with load[0]
    input  wire signed [DW-1:0]       step,
    input  wire signed [CW-1:0]       step_c,
    input  wire [BITS-1:0]            mantissa,  // with load[8]
    input  wire [5:0]                 exponent,
    output wire [UV_WIDTH-1:0]        half       // behind stage 9, unsigned
);
    localparam integer PW = UV_WIDTH + CW;

    reg  signed [PW-1:0] product;
    reg  signed [DW-1:0] step0, step1, turned, change;
    wire signed [DW-1:0] fitted, limited, waited;

    rp_cast #(.W(PW), .SHIFT(UV_FRAC + C_FRAC - DATA_FRAC), .OW(DW)) fit (
        .x(product), .y(fitted)
    );
    rp_cast #(.W(DW + 1), .SHIFT(0), .OW(DW)) limit (
        .x((DW+1)'(step1) - (DW+1)'(turned)), .y(limited)
    );

    always_ff @(posedge clk) begin
        if (load[0]) begin
            product <= PW'(u) * PW'(step_c);
            step0   <= step;
        end
        if (load[1]) begin
            turned <= fitted;
            step1  <= step0;
        end
        if (load[2]) change <= limited;
    end

    rp_delay #(.W(DW), .L(5)) waiting (
        .clk(clk), .load(load[7:3]), .in_data(change), .out_data(waited)
    );

    localparam integer QW = DW + BITS + 1;             // the mantissa becomes signed

    reg  signed [QW-1:0]       scaled;
    reg  [5:0]                 shift;
    reg  signed [UV_WIDTH-1:0] quotient;
    wire signed [UV_WIDTH-1:0] rounded;

    rp_scaled_cast #(
        .W(QW), .LEAST(BITS - 1), .MOST(BITS + 30), .OFFSET(DATA_FRAC + 1 - C_FRAC - UV_FRAC),
        .OW(UV_WIDTH)
    ) to_texels (.x(scaled), .exponent(shift), .y(rounded));

    always_ff @(posedge clk) begin
        if (load[8]) begin
            scaled <= QW'(waited) * $signed(QW'(mantissa));
            shift  <= exponent;
        end
        if (load[9]) quotient <= rounded;
    end

    assign half = quotient[UV_WIDTH-1] ? -quotient : quotient;
endmodule

`default_nettype wire
