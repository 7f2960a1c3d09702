`default_nettype none

// v / |v| by CORDIC in 3 N + 2 register stages: |x|, |y|, |z| shifted up to the longest one's
// leading bit (2), N turns of (x, y) onto the x axis, N of (K r, K z) likewise and of the axis
// itself backwards, and the first N backwards. Bit for bit the datapath's Cordic
// (datapath/numbers/cordic.cpp). The zero vector stays zero.
//
// No handshake of its own: it is part of a unit's pipeline, whose `load` bits enable its stages.
// No multiplier but for the two by the constant K.
module rp_cordic #(
    parameter integer W    = 19,  // bits of x, y, z, at most 24
    parameter integer N    = 19,  // turns, fraction bits of the rounded result + 5
    parameter integer BITS = 24   // fraction bits of the result, N + 5
) (
    input  wire                   clk,
    input  wire [3*N+1:0]         load,   // stage enables, of the unit's rp_pipe
    input  wire signed [W-1:0]    x,
    input  wire signed [W-1:0]    y,
    input  wire signed [W-1:0]    z,
    output wire signed [BITS+3:0] unit_x,
    output wire signed [BITS+3:0] unit_y,
    output wire signed [BITS+3:0] unit_z
);
    localparam integer IN = 24;        // bits of the longest component, in front of the cut to BITS
    localparam integer M  = BITS + 4;  // K^2 |v| < 2^(BITS+3), and a sign
    localparam integer G  = BITS + 1;  // bits of K < 2

    initial if (W > IN || N > 23 || BITS != N + 5)
        $fatal(1, "rp_cordic: W <= 24, N <= 23, BITS = N + 5");

    // K^2 = prod (1 + 4^-i), u2.60, and its root, u1.30, bit by bit; then both constants to
    // nearest.
    function automatic [63:0] squared_gain(input integer turns);
        integer k;
        begin
            squared_gain = 64'd1 << 60;
            for (k = 0; k < turns; k = k + 1)
                squared_gain = squared_gain + (squared_gain >> (2 * k));
        end
    endfunction

    function automatic [63:0] root(input [63:0] square);
        reg [63:0] trial;
        integer    k;
        begin
            root = 64'd0;
            for (k = 31; k >= 0; k = k - 1) begin
                trial = root | (64'd1 << k);
                if (trial * trial <= square) root = trial;
            end
        end
    endfunction

    localparam [63:0] SQUARE = squared_gain(N);
    localparam [63:0] GAIN   = (root(SQUARE) + ((64'd1 << (30 - BITS)) >> 1)) >> (30 - BITS);
    localparam [63:0] START  = ((64'd1 << (30 + BITS)) + (SQUARE >> 31)) / (SQUARE >> 30);

    // Stage 0: magnitudes and the leading zeros of their OR.
    function automatic [IN-1:0] magnitude(input signed [W-1:0] v);
        magnitude = IN'($unsigned(v[W-1] ? W'(-v) : v));
    endfunction

    function automatic [4:0] leading_zeros(input [IN-1:0] v);
        integer k;
        leading_zeros = 5'd0;
        for (k = 0; k < IN; k = k + 1) if (v[k]) leading_zeros = 5'(IN - 1 - k);
    endfunction

    wire [IN-1:0] ax = magnitude(x), ay = magnitude(y), az = magnitude(z);
    reg  [IN-1:0] x0, y0, z0;
    reg  [4:0]    zeros0;

    // Stage 1: shifted, to BITS bits.
    function automatic signed [M-1:0] scaled(input [IN-1:0] v, input [4:0] zeros);
        reg [IN+M-1:0] raised;
        begin
            raised = {{M{1'b0}}, v << zeros} << BITS;
            scaled = M'(raised >> IN);
        end
    endfunction

    reg signed [M-1:0] x1, y1, z1;

    always_ff @(posedge clk) begin
        if (load[0]) begin
            x0     <= ax;
            y0     <= ay;
            z0     <= az;
            zeros0 <= leading_zeros(ax | ay | az);
        end
        if (load[1]) begin
            x1 <= scaled(x0, zeros0);
            y1 <= scaled(y0, zeros0);
            z1 <= scaled(z0, zeros0);
        end
    end

    // Signs, and whether there is a vector at all, wait for the end.
    wire sign_x, sign_y, sign_z, some;
    rp_delay #(.W(4), .L(3 * N + 2)) signs (
        .clk(clk), .load(load), .in_data({|{x, y, z}, z[W-1], y[W-1], x[W-1]}),
        .out_data({some, sign_z, sign_y, sign_x})
    );

    // Multiplied by K, rounded to BITS fraction bits.
    function automatic signed [M-1:0] lengthened(input signed [M-1:0] v);
        reg signed [M+G:0] product;
        begin
            product    = (M+G+1)'(v) * $signed((M+G+1)'(GAIN)) + ((M+G+1)'(1) <<< (BITS - 1));
            lengthened = M'(product >>> BITS);
        end
    endfunction

    // Stages 2 to N + 1: the plane turn. z is multiplied by K meanwhile.
    wire [(N+1)*M-1:0] plane_a, plane_b;
    reg  signed [M-1:0] z2;
    wire signed [M-1:0] kz;

    assign plane_a[M-1:0] = x1;
    assign plane_b[M-1:0] = y1;
    always_ff @(posedge clk) if (load[2]) z2 <= lengthened(z1);
    rp_delay #(.W(M), .L(N - 1)) z_waits (
        .clk(clk), .load(load[N+1:3]), .in_data(z2), .out_data(kz)
    );

    // Stages N + 2 to 2 N + 1: the elevation, off (rise) and onto the axis.
    wire [(N+1)*M-1:0] rise_a, rise_b, axis_a, axis_b;

    assign rise_a[M-1:0] = plane_a[N*M +: M];
    assign rise_b[M-1:0] = kz;
    assign axis_a[M-1:0] = M'(START);
    assign axis_b[M-1:0] = '0;

    // Stages 2 N + 2 to 3 N + 1: back in the plane. The axis' z is multiplied by K meanwhile.
    wire [(N+1)*M-1:0] level_a, level_b;
    reg  signed [M-1:0] up;
    wire signed [M-1:0] height;

    assign level_a[M-1:0] = axis_a[N*M +: M];
    assign level_b[M-1:0] = '0;
    always_ff @(posedge clk) if (load[2*N+2]) up <= lengthened($signed(axis_b[N*M +: M]));
    rp_delay #(.W(M), .L(N - 1)) up_waits (
        .clk(clk), .load(load[3*N+1:2*N+3]), .in_data(up), .out_data(height)
    );

    genvar i;
    generate
        for (i = 0; i < N; i = i + 1) begin : g_turn
            wire down_plane = ~plane_b[i*M + M - 1];
            wire down_rise  = ~rise_b[i*M + M - 1];
            wire down_level;

            rp_cordic_turn #(.W(M), .I(i)) plane (
                .clk(clk), .load(load[2+i]), .clockwise(down_plane),
                .in_a(plane_a[i*M +: M]), .in_b(plane_b[i*M +: M]),
                .out_a(plane_a[(i+1)*M +: M]), .out_b(plane_b[(i+1)*M +: M])
            );
            rp_cordic_turn #(.W(M), .I(i)) rise (
                .clk(clk), .load(load[N+2+i]), .clockwise(down_rise),
                .in_a(rise_a[i*M +: M]), .in_b(rise_b[i*M +: M]),
                .out_a(rise_a[(i+1)*M +: M]), .out_b(rise_b[(i+1)*M +: M])
            );
            rp_cordic_turn #(.W(M), .I(i)) axis (
                .clk(clk), .load(load[N+2+i]), .clockwise(~down_rise),
                .in_a(axis_a[i*M +: M]), .in_b(axis_b[i*M +: M]),
                .out_a(axis_a[(i+1)*M +: M]), .out_b(axis_b[(i+1)*M +: M])
            );
            // What was turned in the plane comes back 2 N stages later.
            rp_delay #(.W(1), .L(2 * N)) waits (
                .clk(clk), .load(load[2+i +: 2*N]), .in_data(down_plane), .out_data(down_level)
            );
            rp_cordic_turn #(.W(M), .I(i)) level (
                .clk(clk), .load(load[2*N+2+i]), .clockwise(~down_level),
                .in_a(level_a[i*M +: M]), .in_b(level_b[i*M +: M]),
                .out_a(level_a[(i+1)*M +: M]), .out_b(level_b[(i+1)*M +: M])
            );
        end
    endgenerate

    wire unused_ends = &{1'b0, plane_b[N*M +: M], rise_a[N*M +: M], rise_b[N*M +: M]};

    function automatic signed [M-1:0] with_sign(input signed [M-1:0] v, input negative);
        with_sign = negative ? -v : v;
    endfunction

    wire [M-1:0] kept = {M{some}};
    assign unit_x = kept & with_sign($signed(level_a[N*M +: M]), sign_x);
    assign unit_y = kept & with_sign($signed(level_b[N*M +: M]), sign_y);
    assign unit_z = kept & with_sign(height, sign_z);
endmodule

`default_nettype wire
