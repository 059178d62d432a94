; example-gather.s - c(i) := table(list(i)), one instruction.

        .include "example-data.inc"

        .regs   r10, lists, from, result

        descriptor lists, list, n
        EX      from, table
        descriptor result, c, n
        VXTOV   [lists], [from], [result]
        EXIT
; expect: [c] = 0.0, 7.0, 14.0, 21.0
