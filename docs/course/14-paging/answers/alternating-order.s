; alternating-order.s - the mean of 20 frames, and how many are above it: the second pass goes back
; from the last frame to the first.

        .include "core.s"

        .ifndef n
        .equ    n, 10                   ; numbers of a frame
        .endif
        .equ    COUNT, 20
        .equ    PAGE, 65536

        .data
mean:   .space  n
above:  .space  n
        .bitvector higher, n
frames: .rept   COUNT
        .rept   n
        .word   1.0 * (\+ % 7)
        .endr
        .space  PAGE - n
        .endr
        .code

        .regs   r10, frame, means, counts, bits, page, left, next_at
        .regs   r20, one, share

        descriptor frame, frames, n
        descriptor means, mean, n
        descriptor counts, above, n
        descriptor bits, higher, n
        EX      page, 64 * PAGE
        load_constant one, 1.0
        load_constant share, 1.0 / COUNT

; repeat N .. again executes the lines between N times.
        .macro  repeat count
        ES      left, \count
        EX      next_at, repeat\@
repeat\@:
        .endm

        .macro  again
        DBNZ    left, [next_at]
        .endm

        .macro  count_above frame
        CMPLTV  [means], [\frame], [bits]
        ADDNV   [counts], one, [counts] ? [bits]
        .endm

        .kernel mean
        VTOV    r0, [means]
        repeat  COUNT
        ADDNV   [means], [frame], [means]
        ADDX    frame, page, frame
        again
        MPYSV   [means], share, [means]
        .endkernel

        .kernel above
        VTOV    r0, [counts]
        repeat  COUNT
        SUBX    frame, page, frame
        count_above frame
        again
        .endkernel
        EXIT
