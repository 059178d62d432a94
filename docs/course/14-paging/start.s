; start.s - the mean of 20 frames, and how many are above it: data and registers are
; complete; the two passes are missing.

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

        descriptor frame, frames, n     ; the first frame; the next one is page bits further
        descriptor means, mean, n
        descriptor counts, above, n
        descriptor bits, higher, n
        EX      page, 64 * PAGE
        load_constant one, 1.0
        load_constant share, 1.0 / COUNT

        .kernel mean
; your code here: mean(i) = the sum of the frames' numbers i, times share
        .endkernel

        .kernel above
; your code here: above(i) = the number of frames whose number i is above mean(i)
        .endkernel
        EXIT
