    // Printed from datapath/units/normal_test_desc.h; the defaults are the profile `default`.
    // A unit need not use all that an entry gives.
    /* verilator lint_off UNUSEDPARAM */
    parameter integer DISPLACED_NORMAL_WIDTH = 13,  // components of N'
    parameter integer DISPLACED_NORMAL_FRAC  = 11,  // of which fraction bits
    parameter integer MAP_NORMAL_WIDTH       = 13,  // a component of N_D
    parameter integer MAP_NORMAL_FRAC        = 11,  // of which fraction bits
    parameter integer NORMAL_WIDTH           = 16,  // components of N and T
    parameter integer NORMAL_FRAC            = 14   // of which fraction bits
    /* verilator lint_on UNUSEDPARAM */
