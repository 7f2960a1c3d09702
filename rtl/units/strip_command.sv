`default_nettype none

// One command of a step, for `strip`, which has four of them in a row. It works on names of
// vertices alone; the vertices themselves are fetched once, when the whole step is known.
//
// A name is {new, i}: the vertex of the step's command i if `new`, else what register i held before
// the step. The state that is passed from command to command is what registers and FIFOs hold by
// name, the strip's last two registers, and what the step has done so far.
//
// Combinational.
module strip_command #(
    parameter integer NUMBER = 0,   // of the command in the step, 0..3
    parameter integer DEPTH  = 256, // places of each FIFO, >= 1
    parameter integer CW     = 9    // bits of a number of them
) (
    input  wire          active,        // the step has this command
    input  wire [5:0]    command,       // operation, register, where the vertex is kept

    // The strip: vertices in it, counted to 2; how to wind; registers of the last two.
    input  wire [6:0]    strip_in,      // {length, odd, older, newer}
    output wire [6:0]    strip_out,
    // Registers: whether each holds a vertex, and its name.
    input  wire [15:0]   registers_in,  // {loaded, name3, name2, name1, name0}
    output wire [15:0]   registers_out,
    // Each FIFO: vertices in it, taken and kept in this step, and the kept ones' commands.
    input  wire [CW+13:0] column_in,    // {count, taken, kept, command of kept 3 .. 0}
    output wire [CW+13:0] column_out,
    input  wire [CW+13:0] split_in,
    output wire [CW+13:0] split_out,
    // The step's yield: bad command, triangles, and theirs as names.
    input  wire [20:0]   made_in,       // {bad, triangles, a1, b1, c1, a0, b0, c0}
    output wire [20:0]   made_out,

    input  wire [2:0]    news_in,       // new vertices used so far
    output wire [2:0]    news_out,

    // Where this command's own vertex comes from, if it brings one: 0 the new vertex, 1 the column
    // FIFO, 2 the split FIFO, and the how manieth of that source.
    output wire [1:0]    source,
    output wire [1:0]    number
);
    localparam [1:0] REF = 2'd0, NEW = 2'd1, COLUMN = 2'd2, SPLIT = 2'd3;  // StripOp
    localparam [1:0] TO_NOTHING = 2'd0, TO_COLUMN = 2'd1;                  // StripKeep
    localparam [CW-1:0] FULL = CW'(DEPTH);

    wire [1:0] op    = command[5:4];
    wire [1:0] place = command[3:2];
    wire [1:0] keep  = command[1:0];

    wire [1:0] length, older, newer;
    wire       odd;
    wire [3:0]  loaded;
    wire [11:0] names;
    assign {length, odd, older, newer} = strip_in;
    assign {loaded, names}             = registers_in;

    // ---- the vertex -----------------------------------------------------------------------------
    // A FIFO still has entries from earlier steps if it holds more than this step has kept.
    wire [CW-1:0] column_count, split_count;
    wire [2:0]    column_taken, column_kept, split_taken, split_kept;
    wire [7:0]    column_from, split_from;  // commands whose vertices this step has kept
    assign {column_count, column_taken, column_kept, column_from} = column_in;
    assign {split_count, split_taken, split_kept, split_from}     = split_in;
    // (It may keep, and take again, more than there are places.)
    wire column_old = {3'd0, column_count} > {{CW{1'b0}}, column_kept};
    wire split_old  = {3'd0, split_count} > {{CW{1'b0}}, split_kept};

    wire is_ref    = op == REF;
    wire is_column = op == COLUMN;
    wire is_split  = op == SPLIT;
    wire exists    = is_ref ? loaded[place]
                   : is_column ? column_count != '0
                   : is_split ? split_count != '0
                   : 1'b1;
    wire used = active & exists;

    assign source = op - NEW;
    assign number = is_column ? column_taken[1:0] : is_split ? split_taken[1:0] : news_in[1:0];

    // One that was kept in this very step has a name already. (At most 3 are kept before a command,
    // so the difference fits two bits.)
    wire [1:0] column_back = column_kept[1:0] - 2'(column_count);
    wire [1:0] split_back  = split_kept[1:0] - 2'(split_count);
    wire [1:0] self = 2'(NUMBER);
    wire [2:0] name = is_ref ? names[place*3 +: 3]
                    : is_column & ~column_old ? {1'b1, column_from[column_back*2 +: 2]}
                    : is_split & ~split_old ? {1'b1, split_from[split_back*2 +: 2]}
                    : {1'b1, self};

    assign news_out = news_in + 3'({used & (op == NEW)});

    // ---- the strip ------------------------------------------------------------------------------
    wire       full   = length == 2'd2;
    wire       swap   = full & is_ref & (place == older);
    wire       makes  = used & full & ~swap;
    wire [2:0] name_a = names[older*3 +: 3];
    wire [2:0] name_b = names[newer*3 +: 3];
    wire [8:0] triangle = {name_a, odd ? name : name_b, odd ? name_b : name};

    assign strip_out = used ? {full ? 2'd2 : length + 2'd1, odd ^ full, newer, place} : strip_in;

    wire       bad;
    wire [1:0] triangles;
    wire [8:0] triangle1, triangle0;
    assign {bad, triangles, triangle1, triangle0} = made_in;

    // ---- registers and FIFOs --------------------------------------------------------------------
    wire loads = used & ~is_ref;
    genvar r;
    generate
        for (r = 0; r < 4; r = r + 1) begin : g_register
            wire here = loads & (place == 2'(r));
            assign registers_out[12+r]    = loaded[r] | here;
            assign registers_out[r*3 +: 3] = here ? name : names[r*3 +: 3];
        end
    endgenerate

    // A FIFO behind this command: first a vertex may be taken, then one kept.
    wire to_column   = loads & (keep == TO_COLUMN);
    wire to_split    = loads & (keep != TO_COLUMN) & (keep != TO_NOTHING);
    wire from_column = used & is_column;
    wire from_split  = used & is_split;
    wire [CW-1:0] column_left = column_count - CW'(from_column);
    wire [CW-1:0] split_left  = split_count - CW'(from_split);
    wire column_push = to_column & (column_left != FULL);
    wire split_push  = to_split & (split_left != FULL);

    assign column_out[CW+13:8] = {column_left + CW'(column_push),
                                  column_taken + 3'(from_column), column_kept + 3'(column_push)};
    assign split_out[CW+13:8]  = {split_left + CW'(split_push),
                                  split_taken + 3'(from_split), split_kept + 3'(split_push)};
    generate
        for (r = 0; r < 4; r = r + 1) begin : g_kept
            assign column_out[r*2 +: 2] =
                (column_push & (column_kept == 3'(r))) ? name[1:0] : column_from[r*2 +: 2];
            assign split_out[r*2 +: 2] =
                (split_push & (split_kept == 3'(r))) ? name[1:0] : split_from[r*2 +: 2];
        end
    endgenerate

    assign made_out = {
        bad | (active & ~exists) | (to_column & ~column_push) | (to_split & ~split_push)
            | (makes & (triangles == 2'd2)),
        (makes & (triangles != 2'd2)) ? triangles + 2'd1 : triangles,
        (makes & (triangles == 2'd1)) ? triangle : triangle1,
        (makes & (triangles == 2'd0)) ? triangle : triangle0
    };
endmodule

`default_nettype wire
