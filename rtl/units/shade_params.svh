    // Printed from datapath/units/shade_desc.h; the defaults are the profile `default`.
    // A unit need not use all that an entry gives.
    /* verilator lint_off UNUSEDPARAM */
    parameter integer POSITION_WIDTH            = 32,  // P and P', in world units
    parameter integer POSITION_FRAC             = 16,  // of which fraction bits
    parameter integer NORMAL_WIDTH              = 16,  // components of N and T
    parameter integer NORMAL_FRAC               = 14,  // of which fraction bits
    parameter integer UNNORMALISED_WIDTH        = 19,  // a vector to be normalised
    parameter integer UNNORMALISED_FRAC         = 16,  // of which fraction bits
    parameter integer COSINE_WIDTH              = 18,  // a cosine in the illumination
    parameter integer COSINE_FRAC               = 16,  // of which fraction bits
    parameter integer LIGHT_WIDTH               = 12,  // a light's colour times the material's
    parameter integer LIGHT_FRAC                = 10,  // of which fraction bits
    parameter integer COLOUR_WIDTH              = 10,  // a vertex's colour
    parameter integer COLOUR_FRAC               = 10,  // of which fraction bits
    parameter integer LIGHTS                    = 8,   // lights of the illumination
    parameter integer POWER_LOG_INDEX_BITS      = 5,   // log2 of the logarithm's table in x^n
    parameter integer POWER_EXP_INDEX_BITS      = 6,   // log2 of the exponential's table in x^n
    parameter integer NORMALISE_KIND            = 0,   // unit vectors by: 0 inverse square root, 1 CORDIC
    parameter integer INVERSE_SQRT_INDEX_BITS   = 7,   // log2 of the inverse square root's table
    parameter integer INVERSE_SQRT_NEWTON_STEPS = 2,   // Newton steps of the inverse square root
    parameter integer INVERSE_SQRT_BITS         = 24   // mantissa bits of the inverse square root
    /* verilator lint_on UNUSEDPARAM */
