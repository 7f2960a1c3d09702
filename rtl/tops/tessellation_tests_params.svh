    // Printed from datapath/pipelines/tessellation_tests_desc.h; the defaults are the profile `default`.
    // A unit need not use all that an entry gives.
    /* verilator lint_off UNUSEDPARAM */
    parameter integer UV_WIDTH               = 23,  // texture coordinates, in texels
    parameter integer UV_FRAC                = 8,   // of which fraction bits
    parameter integer SCREEN_WIDTH           = 18,  // pixels
    parameter integer SCREEN_FRAC            = 4,   // of which fraction bits
    parameter integer DISPLACED_NORMAL_WIDTH = 13,  // components of N'
    parameter integer DISPLACED_NORMAL_FRAC  = 11,  // of which fraction bits
    parameter integer MAP_NORMAL_WIDTH       = 13,  // a component of N_D
    parameter integer MAP_NORMAL_FRAC        = 11,  // of which fraction bits
    parameter integer NORMAL_WIDTH           = 16,  // components of N and T
    parameter integer NORMAL_FRAC            = 14,  // of which fraction bits
    parameter integer SAT_WIDTH              = 38,  // stored bits of the summed-area table
    parameter integer HEIGHT_WIDTH           = 16,  // a texel of the displacement map
    parameter integer HEIGHT_FRAC            = 16   // of which fraction bits
    /* verilator lint_on UNUSEDPARAM */
