    // Printed from datapath/units/split_desc.h; the defaults are the profile `default`.
    // A unit need not use all that an entry gives.
    /* verilator lint_off UNUSEDPARAM */
    parameter integer POSITION_WIDTH = 32,  // P and P', in world units
    parameter integer POSITION_FRAC  = 16,  // of which fraction bits
    parameter integer DIAGONAL_WIDTH = 30,  // differences of P' in split
    parameter integer DIAGONAL_FRAC  = 16   // of which fraction bits
    /* verilator lint_on UNUSEDPARAM */
