; example-overlap.s - running sums by one instruction whose result overlaps its source.

        .include "example-data.inc"

        .data
x:      .word   1.0                     ; b(0)
        .space  n - 1
        .code

        .regs   r10, right, before, xs

        descriptor right, b + 64, n - 1
        descriptor before, x, n - 1
        descriptor xs, x + 64, n - 1
        ADDNV   [before], [right], [xs]
        EXIT
; expect: [x + 64 * (n - 1)] = 1000.0
; expect-warning: recurrence
