; example-once.s - the sums of the columns, all at the same time: row by row.

        .include "example-data.inc"

        .regs   r10, row, result, bits, i, one, count

        descriptor row, a, n
        descriptor result, sums, n
        EX      bits, 64 * n
        ES      count, n
        ES      one, 1
        ES      i, 0
next:   ADDNV   [result], [row], [result]
        ADDX    row, bits, row
        IBXLT   i, one, count, next, i
        EXIT
; expect: [sums] = 129024.0, 129088.0, 129152.0
