    // Printed from datapath/units/shade_desc.h; the defaults are the profile `default`.
    // A unit need not use all that an entry gives.
    /* verilator lint_off UNUSEDPARAM */
    parameter integer NORMAL_WIDTH         = 16,  // components of N and T
    parameter integer NORMAL_FRAC          = 14,  // of which fraction bits
    parameter integer COSINE_WIDTH         = 18,  // a cosine in the illumination
    parameter integer COSINE_FRAC          = 16,  // of which fraction bits
    parameter integer LIGHT_WIDTH          = 12,  // a light's colour times the material's
    parameter integer LIGHT_FRAC           = 10,  // of which fraction bits
    parameter integer COLOUR_WIDTH         = 10,  // a vertex's colour
    parameter integer COLOUR_FRAC          = 10,  // of which fraction bits
    parameter integer LIGHTS               = 8,   // lights of the illumination
    parameter integer POWER_LOG_INDEX_BITS = 5,   // log2 of the logarithm's table in x^n
    parameter integer POWER_EXP_INDEX_BITS = 6    // log2 of the exponential's table in x^n
    /* verilator lint_on UNUSEDPARAM */
