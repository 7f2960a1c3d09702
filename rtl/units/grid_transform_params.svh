    // Printed from datapath/units/grid_transform_desc.h; the defaults are the profile `default`.
    // A unit need not use all that an entry gives.
    /* verilator lint_off UNUSEDPARAM */
    parameter integer POSITION_WIDTH          = 32,  // P and P', in world units
    parameter integer POSITION_FRAC           = 16,  // of which fraction bits
    parameter integer CLIP_WIDTH              = 32,  // P' in eye space
    parameter integer CLIP_FRAC               = 16,  // of which fraction bits
    parameter integer NDC_WIDTH               = 31,  // eye-space x/w and y/w
    parameter integer NDC_FRAC                = 22,  // of which fraction bits
    parameter integer FOCAL_WIDTH             = 22,  // pixels per unit of x/w; the centre
    parameter integer FOCAL_FRAC              = 8,   // of which fraction bits
    parameter integer SWEEP_DATA_WIDTH        = 32,  // attributes times c
    parameter integer SWEEP_DATA_FRAC         = 16,  // of which fraction bits
    parameter integer INVERSE_W_WIDTH         = 32,  // c = w_scale / w
    parameter integer INVERSE_W_FRAC          = 30,  // of which fraction bits
    parameter integer STEPS_PER_OCTAVE_WIDTH  = 24,  // grid steps in depth for each doubling of w
    parameter integer STEPS_PER_OCTAVE_FRAC   = 11,  // of which fraction bits
    parameter integer Z_TABLE_KIND            = 1,   // depth table: 0 uniform, 1 linear by octaves, 2 quadratic by octaves
    parameter integer Z_TABLE_INDEX_BITS      = 6,   // log2 of the depth table's entries
    parameter integer RECIPROCAL_INDEX_BITS   = 7,   // log2 of the reciprocal's table
    parameter integer RECIPROCAL_NEWTON_STEPS = 2,   // Newton steps of the reciprocal
    parameter integer RECIPROCAL_BITS         = 24   // mantissa bits of the reciprocal
    /* verilator lint_on UNUSEDPARAM */
