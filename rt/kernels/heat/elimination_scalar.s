; elimination_scalar.s - the elimination of elimination.s, word by word.

        .regs   r44, lin_from, lin_to, lin_count, lin_i

; Adds the words at lin_from times the factor to the lin_count words at lin_to.
; lin_count is at least 1.
        .macro  add_times factor
        ES      lin_i, 0
add_next\@:
        LOD     [lin_from, lin_i], lin_work1
        LOD     [lin_to, lin_i], lin_work2
        MPYS    lin_work1, \factor, lin_work1
        ADDN    lin_work1, lin_work2, lin_work1
        STO     [lin_to, lin_i], lin_work1
        IBXNE   lin_i, lin_one, lin_count, add_next\@, lin_i
        .endm

        .macro  eliminate singular
        RTOR    lin_matrix, lin_at
        ES      lin_k, 0
eliminate_step:
        LOD     [lin_at], lin_pivot
        CFPLT   lin_pivot, lin_least, \singular
        ADDX    lin_k, lin_one, lin_row
        SUBX    lin_n, lin_row, lin_count
        IBXEQ   lin_count, r0, r0, eliminated
        RTOR    lin_at, lin_from
        IX      lin_from, 64
        ES      lin_i, 0
eliminate_divide:
        LOD     [lin_from, lin_i], lin_work0
        DIVS    lin_work0, lin_pivot, lin_work0
        STO     [lin_from, lin_i], lin_work0
        IBXNE   lin_i, lin_one, lin_count, eliminate_divide, lin_i
        ADDX    lin_at, lin_stride, lin_row     ; A(k, j)
        RTOR    lin_count, lin_left
eliminate_next:
        LOD     [lin_row], lin_work0
        SUBN    r0, lin_work0, lin_work0
        RTOR    lin_row, lin_to
        IX      lin_to, 64
        add_times lin_work0
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
        RTOR    lin_b, lin_to
solve_back:
        SUBX    lin_column, lin_stride, lin_column
        SUBX    lin_k, lin_one, lin_k
        LOD     [lin_column, lin_k], lin_pivot
        LOD     [lin_b, lin_k], lin_work0
        DIVS    lin_work0, lin_pivot, lin_work0
        STO     [lin_x, lin_k], lin_work0
        IBXEQ   lin_k, r0, r0, \solved
        SUBN    r0, lin_work0, lin_work0
        RTOR    lin_column, lin_from
        RTOR    lin_k, lin_count
        add_times lin_work0
        BIM     solve_back
        .endm
