    // Printed from datapath/units/bump_desc.h; the defaults are the profile `default`.
    // A unit need not use all that an entry gives.
    /* verilator lint_off UNUSEDPARAM */
    parameter integer UV_WIDTH                  = 23,  // texture coordinates, in texels
    parameter integer UV_FRAC                   = 8,   // of which fraction bits
    parameter integer HEIGHT_WIDTH              = 16,  // a texel of the displacement map
    parameter integer HEIGHT_FRAC               = 16,  // of which fraction bits
    parameter integer MAP_NORMAL_WIDTH          = 13,  // a component of N_D
    parameter integer MAP_NORMAL_FRAC           = 11,  // of which fraction bits
    parameter integer NORMAL_WIDTH              = 16,  // components of N and T
    parameter integer NORMAL_FRAC               = 14,  // of which fraction bits
    parameter integer UNNORMALISED_WIDTH        = 19,  // a vector to be normalised
    parameter integer UNNORMALISED_FRAC         = 16,  // of which fraction bits
    parameter integer DISPLACED_NORMAL_WIDTH    = 13,  // components of N'
    parameter integer DISPLACED_NORMAL_FRAC     = 11,  // of which fraction bits
    parameter integer BUMP_KIND                 = 0,   // displaced normals by: 0 stored normals, 1 differences of heights, 2 two angles
    parameter integer SLOPE_WIDTH               = 20,  // derivatives of D along T and B
    parameter integer SLOPE_FRAC                = 14,  // of which fraction bits
    parameter integer ANGLE_WIDTH               = 16,  // a stored rotation angle, in half turns
    parameter integer ANGLE_FRAC                = 15,  // of which fraction bits
    parameter integer SINE_INDEX_BITS           = 6,   // log2 of the sine table's entries
    parameter integer NORMALISE_KIND            = 0,   // unit vectors by: 0 inverse square root, 1 CORDIC
    parameter integer INVERSE_SQRT_INDEX_BITS   = 7,   // log2 of the inverse square root's table
    parameter integer INVERSE_SQRT_NEWTON_STEPS = 2,   // Newton steps of the inverse square root
    parameter integer INVERSE_SQRT_BITS         = 24   // mantissa bits of the inverse square root
    /* verilator lint_on UNUSEDPARAM */
