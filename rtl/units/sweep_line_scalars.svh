        // The fields of a base triangle but for its vertex data, in the order of the transaction.
        single, continues, mirrored, sweep_start, determinant, step_limit, half0_columns,
        half0_down, half0_flip, half0_tip, half0_closing, half0_other_left, half0_other_right,
        half1_columns, half1_down, half1_flip, half1_tip, half1_closing, half1_other_left,
        half1_other_right, walk0_edge, walk0_from, walk0_to, walk0_backward, walk0_steps, walk0_row,
        walk0_row_quotient, walk0_row_rest, walk1_edge, walk1_from, walk1_to, walk1_backward,
        walk1_steps, walk1_row, walk1_row_quotient, walk1_row_rest, edge0_edge, edge0_from,
        edge0_to, edge0_backward, edge0_steps, edge0_row, edge0_row_quotient, edge0_row_rest,
        edge1_edge, edge1_from, edge1_to, edge1_backward, edge1_steps, edge1_row,
        edge1_row_quotient, edge1_row_rest
