    // Printed from datapath/units/footprint_desc.h; the defaults are the profile `default`.
    // A unit need not use all that an entry gives.
    /* verilator lint_off UNUSEDPARAM */
    parameter integer UV_WIDTH                = 23,  // texture coordinates, in texels
    parameter integer UV_FRAC                 = 8,   // of which fraction bits
    parameter integer POSITION_WIDTH          = 32,  // P and P', in world units
    parameter integer POSITION_FRAC           = 16,  // of which fraction bits
    parameter integer NORMAL_WIDTH            = 16,  // components of N and T
    parameter integer NORMAL_FRAC             = 14,  // of which fraction bits
    parameter integer SWEEP_DATA_WIDTH        = 32,  // attributes times c
    parameter integer SWEEP_DATA_FRAC         = 16,  // of which fraction bits
    parameter integer INVERSE_W_WIDTH         = 32,  // c = w_scale / w
    parameter integer INVERSE_W_FRAC          = 30,  // of which fraction bits
    parameter integer RECIPROCAL_INDEX_BITS   = 7,   // log2 of the reciprocal's table
    parameter integer RECIPROCAL_NEWTON_STEPS = 2,   // Newton steps of the reciprocal
    parameter integer RECIPROCAL_BITS         = 24   // mantissa bits of the reciprocal
    /* verilator lint_on UNUSEDPARAM */
