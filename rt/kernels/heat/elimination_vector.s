; elimination_vector.s - the elimination of elimination.s, by whole columns.

        .regs   r44, v_a, v_b, v_c, v_d, v_e

        .macro  eliminate singular
        RTOR    lin_matrix, lin_at
        ES      lin_k, 0
eliminate_step:
        LOD     [lin_at], lin_pivot
        CFPLT   lin_pivot, lin_least, \singular
        ADDX    lin_k, lin_one, lin_row
        SUBX    lin_n, lin_row, lin_below
        IBXEQ   lin_below, r0, r0, eliminated
        ADDX    lin_at, r0, v_a
        IX      v_a, 64
        ADDLEN  v_a, lin_below, v_a
        DIVSV   [v_a], lin_pivot, [v_a]
        ADDX    lin_at, lin_stride, lin_row     ; A(k, j)
        RTOR    lin_below, lin_left
eliminate_next:
        LOD     [lin_row], lin_work0
        SUBN    r0, lin_work0, lin_work0
        ADDX    lin_row, r0, v_c
        IX      v_c, 64
        ADDLEN  v_c, lin_below, v_c
        RTOR    v_c, v_d
        LINKV
        MPYSV   [v_a], lin_work0, [v_d]
        ADDNV   [v_d], [v_c], [v_c]
        ADDX    lin_row, lin_stride, lin_row
        IBXGE   lin_left, lin_minus_one, r0, eliminate_next, lin_left
        IX      lin_at, 64
        ADDX    lin_at, lin_stride, lin_at
        IBXNE   lin_k, lin_one, lin_n, eliminate_step, lin_k
eliminated:
        .endm

        .macro  solve solved
        RTOR    lin_n, lin_k
        RTOR    lin_b, lin_column
solve_back:
        SUBX    lin_column, lin_stride, lin_column
        SUBX    lin_k, lin_one, lin_k
        LOD     [lin_column, lin_k], lin_pivot
        LOD     [lin_b, lin_k], lin_work0
        DIVS    lin_work0, lin_pivot, lin_work0
        STO     [lin_x, lin_k], lin_work0
        IBXEQ   lin_k, r0, r0, \solved
        SUBN    r0, lin_work0, lin_work0
        ADDLEN  lin_column, lin_k, v_a
        ADDLEN  lin_b, lin_k, v_b
        RTOR    v_b, v_d
        LINKV
        MPYSV   [v_a], lin_work0, [v_d]
        ADDNV   [v_d], [v_b], [v_b]
        BIM     solve_back
        .endm
