; test: 20 frames of a single number
; tolerance: mean 1e-9
        .equ    n, 1

        .data
frames: .rept   20
        .word   1.5 * (\+ * \+ - 200)
        .space  65535
        .endr
want_mean:
        .word   -114.75
want_above:
        .word   8.0
