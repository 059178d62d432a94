; functions.s - damped oscillation y = e^(-x/8) cos x, for numbers and vectors.
;
; Both forms of a routine execute the same operations, so results are equal.

        .include "print.s"
        .include "exp.s"
        .include "sin.s"

        .ifndef n
        .equ    n, 1000
        .endif

        .data
xs:     .space  n
halves: .space  n                       ; -x / 8
ys:     .space  n
zs:     .space  n
        .code

        .regs   r10, x, damping, y, z, i, one, count, first, step
        .regs   r20, decay, wave, text

        descriptor x, xs, n
        descriptor damping, halves, n
        descriptor y, ys, n
        descriptor z, zs, n
        load_constant first, 0.0
        load_constant step, 0.02
        INTVLV  first, step, [x]
        load_constant step, -0.125
        MPYSV   [x], step, [damping]

        .kernel numbers
        ES      i, 0
        ES      one, 1
        ES      count, n
each:   LOD     [damping, i], decay
        apply   exp, decay, decay
        LOD     [x, i], wave
        apply   cos, wave, wave
        MPYS    decay, wave, decay
        STO     [y, i], decay
        IBXLT   i, one, count, each, i
        .endkernel

        .kernel vectors
        apply   vexp, damping, damping
        apply   vcos, x, x
        MPYSV   [damping], [x], [z]
        .endkernel

        SELNEV  [y], [z], i
        print_text "words that are the same: ", text
        print_integer i
        newline
        EXIT
; expect-print: words that are the same: 1000
