        // The vertex data of a base triangle, in the order of the transaction.
        corner0, corner1, corner2, walk0_start, walk0_step, walk0_rest, walk1_start, walk1_step,
        walk1_rest, edge0_start, edge0_step, edge0_rest, edge1_start, edge1_step, edge1_rest, base0,
        base1, sweep_step, sweep_rest, side_step, side_rest
