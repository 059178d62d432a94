; example-period.s - every period-th word of a table, 1,000 of them.

        .include "core.s"

        .ifndef period
        .equ    period, 1
        .endif
        .equ    n, 1000

        .data
table:  .space  n * 44
c:      .space  n
        .code

        .regs   r10, step, from, result

        ES      step, period
        EX      from, table
        descriptor result, c, n
        VGATHP  step, [from], [result]
        EXIT
; expect: [c] = 0
