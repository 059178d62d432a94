; test: 20 frames of 6 numbers, some of which equal their mean; results are not zero before
; tolerance: mean 1e-9
        .equ    n, 6

; Frame k: k, 20 - k, k times k, -k times k, 1 every fifth time, -2 .. 2.
        .data
frames: .rept   20
        .word   \+.0, 20.0 - \+, 1.0 * \+ * \+, -1.0 * \+ * \+, 1.0 * (\+ % 5 == 0), \+ % 5 - 2.0
        .space  65536 - 6
        .endr
mean:   .word   7.0, 7.0, 7.0, 7.0, 7.0, 7.0
above:  .word   7.0, 7.0, 7.0, 7.0, 7.0, 7.0
want_mean:
        .word   9.5, 10.5, 123.5, -123.5, 0.2, 0.0
want_above:
        .word   10.0, 10.0, 8.0, 12.0, 4.0, 8.0
