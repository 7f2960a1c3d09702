    // Printed from datapath/units/view_clip_desc.h; the defaults are the profile `default`.
    // A unit need not use all that an entry gives.
    /* verilator lint_off UNUSEDPARAM */
    parameter integer DISPLACEMENT_WIDTH = 32,  // D, in world units
    parameter integer DISPLACEMENT_FRAC  = 20,  // of which fraction bits
    parameter integer VIEW_ROW_WIDTH     = 24,  // right, up and forward
    parameter integer VIEW_ROW_FRAC      = 22,  // of which fraction bits
    parameter integer CLIP_WIDTH         = 32,  // P' in eye space
    parameter integer CLIP_FRAC          = 16   // of which fraction bits
    /* verilator lint_on UNUSEDPARAM */
