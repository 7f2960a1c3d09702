    // Printed from datapath/units/strip_desc.h; the defaults are the profile `default`.
    // A unit need not use all that an entry gives.
    /* verilator lint_off UNUSEDPARAM */
    parameter integer COLUMN_DEPTH = 256  // vertices in the column FIFO; 0: one lane
    /* verilator lint_on UNUSEDPARAM */
