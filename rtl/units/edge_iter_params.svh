    // Printed from datapath/units/edge_iter_desc.h; the defaults are the profile `default`.
    // A unit need not use all that an entry gives.
    /* verilator lint_off UNUSEDPARAM */
    /* verilator lint_on UNUSEDPARAM */
