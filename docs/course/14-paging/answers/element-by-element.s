; element-by-element.s - the mean of 20 frames, and how many are above it, in a loop over
; single elements.

        .include "core.s"

        .ifndef n
        .equ    n, 10                   ; numbers of a frame
        .endif
        .equ    COUNT, 20
        .equ    PAGE, 65536

        .data
mean:   .space  n
above:  .space  n
frames: .rept   COUNT
        .rept   n
        .word   1.0 * (\+ % 7)
        .endr
        .space  PAGE - n
        .endr
        .code

        .regs   r10, first, frame, means, counts, page, left, adding, comparing
        .regs   r20, i, index_one, length, one, share, value, sum, number

        EX      first, frames
        EX      means, mean
        EX      counts, above
        EX      page, 64 * PAGE
        EX      adding, add
        EX      comparing, compare
        ES      i, 0
        ES      index_one, 1
        EX      length, n
        load_constant one, 1.0
        load_constant share, 1.0 / COUNT

element:
        load_constant sum, 0.0
        load_constant number, 0.0
        RTOR    first, frame
        ES      left, COUNT
add:    LOD     [frame, i], value
        ADDX    frame, page, frame
        ADDN    sum, value, sum
        DBNZ    left, [adding]
        MPYS    sum, share, sum
        STO     [means, i], sum
        RTOR    first, frame
        ES      left, COUNT
compare:
        LOD     [frame, i], value
        ADDX    frame, page, frame
        CFPGE   sum, value, not_above
        ADDN    number, one, number
not_above:
        DBNZ    left, [comparing]
        STO     [counts, i], number
        IBXLT   i, index_one, length, element, i
        EXIT
