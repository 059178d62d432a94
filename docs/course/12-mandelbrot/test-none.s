; test: all points have left before the last step
; tolerance: counts 0.1
        .equ    n, 3
        .equ    most, 100
        .warm
        .data
cx:     .word   1.0, 0.5, 2.0
cy:     .word   1.0, 0.0, 2.0

; 1 + i: |1 + i|^2 = 2, then 1 + 3 i.
want_counts:
        .word   2, 5, 1
want_total:
        .word   8.0
