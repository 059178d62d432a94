; example-loop.s - c(i) := table(list(i)), one element after another.

        .include "example-data.inc"

        .regs   r10, lists, from, result, i, one, count, index, element

        EX      lists, list
        EX      from, table
        EX      result, c
        ES      i, 0
        ES      one, 1
        ES      count, n
next:   LOD     [lists, i], index
        LOD     [from, index], element
        STO     [result, i], element
        IBXLT   i, one, count, next, i
        EXIT
; expect: [c] = 0.0, 7.0, 14.0, 21.0
