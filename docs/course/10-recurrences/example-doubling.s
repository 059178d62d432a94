; example-doubling.s - running sums by doubling: after the pass with distance s each element
; is the sum of 2 s neighbours.

        .include "example-data.inc"

        .data
        .space  n                       ; zeros before the first element
x:      .rept   n
        .word   1.0
        .endr
        .space  n
y:      .space  n
        .code

        .regs   r10, from, shifted, to, other, distance, limit

        descriptor from, x, n
        descriptor to, y, n
        EX      distance, 64
        EX      limit, 64 * n
next:   SUBX    from, distance, shifted
        ADDNV   [from], [shifted], [to]
        RTOR    to, other               ; the result is the source of the next pass
        RTOR    from, to
        RTOR    other, from
        IBXLT   distance, distance, limit, next, distance
        EXIT
; expect: [x + 64 * (n - 1)] = 1000.0
