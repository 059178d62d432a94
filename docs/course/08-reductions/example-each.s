; example-each.s - the sums of the columns, one reduction for each.

        .include "example-data.inc"

        .regs   r10, from, columns, period, result, j, one, count
        .regs   r20, upper, lower, word

        EX      from, a
        descriptor columns, column, n
        EX      result, sums
        ES      period, n
        ES      count, n
        ES      one, 1
        ES      j, 0
        ES      word, 64
next:   VGATHP  period, [from], [columns]
        SUMV    [columns], upper
        join_parts upper, lower, upper
        STO     [result, j], upper
        ADDX    from, word, from
        IBXLT   j, one, count, next, j
        EXIT
; expect: [sums] = 129024.0, 129088.0, 129152.0
