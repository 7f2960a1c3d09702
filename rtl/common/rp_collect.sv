`default_nettype none

// The inverse of rp_expand: swallows beats until the one marked last, which it offers downstream.
// What is gathered from the beats is kept in the user's registers enabled by `load`. They are the
// registers of the stage that the last beat enters, so all beats wait while that stage is taken.
// Combinational.
//
// Time: every beat departs at T = max(V, R).
module rp_collect (
    input  wire in_valid,
    output wire in_ready,
    input  wire in_last,    // this beat completes an item
    output wire out_valid,
    input  wire out_ready,
    output wire load        // a beat is taken in this cycle
);
    assign in_ready  = out_ready;
    assign out_valid = in_valid & in_last;
    assign load      = in_valid & in_ready;
endmodule

`default_nettype wire
