    // Printed from datapath/units/texel_cache_desc.h; the defaults are the profile `default`.
    // A unit need not use all that an entry gives.
    /* verilator lint_off UNUSEDPARAM */
    parameter integer HEIGHT_WIDTH      = 16,  // a texel of the displacement map
    parameter integer HEIGHT_FRAC       = 16,  // of which fraction bits
    parameter integer CACHE_LINE_BITS   = 3,   // log2 of the texels in a line of a texel cache
    parameter integer CACHE_SET_BITS    = 6,   // log2 of the sets of a texel cache
    parameter integer CACHE_WAYS        = 4,   // lines in a set of a texel cache
    parameter integer CACHE_REPLACEMENT = 1    // of the line that is replaced: 0 the oldest, 1 the least recently used
    /* verilator lint_on UNUSEDPARAM */
