`default_nettype none

// rp_scatter, a pipeline for the parts, and rp_gather, as in rtl/tops/sweep_chain.sv.
module rtl_queues #(
    parameter integer SCATTER = 32,
    parameter integer STEPS   = 64,
    parameter integer GATHER  = 8,
    parameter integer STAGES  = 10
) (
    input  wire        clk,
    input  wire        rst_n,
    input  wire        in_valid,
    output wire        in_ready,
    input  wire [15:0] in_item,
    input  wire [2:0]  in_n,
    input  wire [63:0] in_parts,
    output wire        out_valid,
    input  wire        out_ready,
    output wire [15:0] out_item,
    output wire [2:0]  out_n,
    output wire [63:0] out_parts,
    output wire        part_leaves,   // rp_scatter
    output wire        part_arrives   // at rp_gather
);
    wire              item_valid, item_ready, part_valid, part_ready, piped_valid, piped_ready;
    wire [15:0]       item, part, piped;
    wire [2:0]        item_n;
    wire [STAGES-1:0] unused_load;

    rp_scatter #(.IW(16), .W(16), .D(SCATTER), .N(4)) scatter (
        .clk(clk), .rst_n(rst_n), .in_valid(in_valid), .in_ready(in_ready), .in_item(in_item),
        .in_n(in_n), .in_parts(in_parts), .item_valid(item_valid), .item_ready(item_ready),
        .item(item), .item_n(item_n), .part_valid(part_valid), .part_ready(part_ready), .part(part)
    );
    rp_pipe #(.W(16), .L(STAGES)) stages (
        .clk(clk), .rst_n(rst_n), .in_valid(part_valid), .in_ready(part_ready), .in_data(part),
        .out_valid(piped_valid), .out_ready(piped_ready), .out_data(piped), .load(unused_load)
    );
    rp_gather #(.IW(16), .W(16), .DI(STEPS), .D(GATHER), .N(4)) gather (
        .clk(clk), .rst_n(rst_n), .item_valid(item_valid), .item_ready(item_ready), .item(item),
        .item_n(item_n), .part_valid(piped_valid), .part_ready(piped_ready), .part(piped),
        .out_valid(out_valid), .out_ready(out_ready), .out_item(out_item), .out_n(out_n),
        .out_parts(out_parts)
    );

    assign part_leaves  = part_valid & part_ready;
    assign part_arrives = piped_valid & piped_ready;
endmodule

`default_nettype wire
