    // Printed from datapath/units/height_test_desc.h; the defaults are the profile `default`.
    // A unit need not use all that an entry gives.
    /* verilator lint_off UNUSEDPARAM */
    parameter integer UV_WIDTH     = 23,  // texture coordinates, in texels
    parameter integer UV_FRAC      = 8,   // of which fraction bits
    parameter integer SAT_WIDTH    = 38,  // stored bits of the summed-area table
    parameter integer HEIGHT_WIDTH = 16,  // a texel of the displacement map
    parameter integer HEIGHT_FRAC  = 16   // of which fraction bits
    /* verilator lint_on UNUSEDPARAM */
