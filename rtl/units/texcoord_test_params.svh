    // Printed from datapath/units/texcoord_test_desc.h; the defaults are the profile `default`.
    // A unit need not use all that an entry gives.
    /* verilator lint_off UNUSEDPARAM */
    parameter integer UV_WIDTH = 23,  // texture coordinates, in texels
    parameter integer UV_FRAC  = 8    // of which fraction bits
    /* verilator lint_on UNUSEDPARAM */
