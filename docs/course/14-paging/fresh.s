; test: frames of other lengths
; tolerance: mean 1e-9

        .ifdef  test_n
        .equ    n, test_n
        .else
        .equ    n, 2 + draw % 60
        .endif

; No number equals the mean: the sum of a number over all frames is 1 more than a multiple of
; 3, and 20 times a number is not.
        .macro  number i, k
        .word   float((\i * 29 + \k * \k * 17 + \k * 41 + draw * 7) % 211 * 3 + (\k == 0))
        .endm

        .macro  frame k
        .rept   n
        number  \+, \k
        .endr
        .space  65536 - n
        .endm

        .data
frames: .rept   20
        frame   \+
        .endr
want_mean:
        .space  n
want_above:
        .space  n
