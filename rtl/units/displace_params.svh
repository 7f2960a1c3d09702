    // Printed from datapath/units/displace_desc.h; the defaults are the profile `default`.
    // A unit need not use all that an entry gives.
    /* verilator lint_off UNUSEDPARAM */
    parameter integer UV_WIDTH              = 23,  // texture coordinates, in texels
    parameter integer UV_FRAC               = 8,   // of which fraction bits
    parameter integer HEIGHT_WIDTH          = 16,  // a texel of the displacement map
    parameter integer HEIGHT_FRAC           = 16,  // of which fraction bits
    parameter integer FILTERED_HEIGHT_WIDTH = 24,  // a bilinear height
    parameter integer FILTERED_HEIGHT_FRAC  = 24,  // of which fraction bits
    parameter integer DISPLACEMENT_WIDTH    = 32,  // D, in world units
    parameter integer DISPLACEMENT_FRAC     = 20,  // of which fraction bits
    parameter integer POSITION_WIDTH        = 32,  // P and P', in world units
    parameter integer POSITION_FRAC         = 16,  // of which fraction bits
    parameter integer NORMAL_WIDTH          = 16,  // components of N and T
    parameter integer NORMAL_FRAC           = 14   // of which fraction bits
    /* verilator lint_on UNUSEDPARAM */
