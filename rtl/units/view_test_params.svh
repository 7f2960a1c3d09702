    // Printed from datapath/units/view_test_desc.h; the defaults are the profile `default`.
    // A unit need not use all that an entry gives.
    /* verilator lint_off UNUSEDPARAM */
    parameter integer SCREEN_WIDTH = 18,  // pixels
    parameter integer SCREEN_FRAC  = 4    // of which fraction bits
    /* verilator lint_on UNUSEDPARAM */
