    // Printed from datapath/pipelines/sweep_chain_desc.h; the defaults are the profile `default`.
    // A unit need not use all that an entry gives.
    /* verilator lint_off UNUSEDPARAM */
    parameter integer UV_WIDTH                = 23,  // texture coordinates, in texels
    parameter integer UV_FRAC                 = 8,   // of which fraction bits
    parameter integer POSITION_WIDTH          = 32,  // P and P', in world units
    parameter integer POSITION_FRAC           = 16,  // of which fraction bits
    parameter integer UNNORMALISED_WIDTH      = 19,  // a vector to be normalised
    parameter integer UNNORMALISED_FRAC       = 16,  // of which fraction bits
    parameter integer SWEEP_DATA_WIDTH        = 32,  // attributes times c
    parameter integer SWEEP_DATA_FRAC         = 16,  // of which fraction bits
    parameter integer INVERSE_W_WIDTH         = 32,  // c = w_scale / w
    parameter integer INVERSE_W_FRAC          = 30,  // of which fraction bits
    parameter integer ADDER_KIND              = 2,   // adders of the sweep: 0 plain, 1 canonical, 2 exact
    parameter integer GUARD_BITS              = 0,   // below the LSB of sweep_data; exact adders need none
    parameter integer COLUMN_DEPTH            = 256,  // vertices in the column FIFO; 0: one lane
    parameter integer COMPONENTS              = 13,  // components of a vertex that the sweep's registers hold
    parameter integer RECIPROCAL_INDEX_BITS   = 7,   // log2 of the reciprocal's table
    parameter integer RECIPROCAL_NEWTON_STEPS = 2,   // Newton steps of the reciprocal
    parameter integer RECIPROCAL_BITS         = 24   // mantissa bits of the reciprocal
    /* verilator lint_on UNUSEDPARAM */
