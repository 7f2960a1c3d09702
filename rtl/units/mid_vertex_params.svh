    // Printed from datapath/units/mid_vertex_desc.h; the defaults are the profile `default`.
    // A unit need not use all that an entry gives.
    /* verilator lint_off UNUSEDPARAM */
    parameter integer UV_WIDTH                  = 23,  // texture coordinates, in texels
    parameter integer UV_FRAC                   = 8,   // of which fraction bits
    parameter integer POSITION_WIDTH            = 32,  // P and P', in world units
    parameter integer POSITION_FRAC             = 16,  // of which fraction bits
    parameter integer NORMAL_WIDTH              = 16,  // components of N and T
    parameter integer NORMAL_FRAC               = 14,  // of which fraction bits
    parameter integer UNNORMALISED_WIDTH        = 19,  // a vector to be normalised
    parameter integer UNNORMALISED_FRAC         = 16,  // of which fraction bits
    parameter integer NORMALISE_KIND            = 0,   // unit vectors by: 0 inverse square root, 1 CORDIC
    parameter integer INVERSE_SQRT_INDEX_BITS   = 7,   // log2 of the inverse square root's table
    parameter integer INVERSE_SQRT_NEWTON_STEPS = 2,   // Newton steps of the inverse square root
    parameter integer INVERSE_SQRT_BITS         = 24   // mantissa bits of the inverse square root
    /* verilator lint_on UNUSEDPARAM */
