; test: another number of quartics
; tolerance: root 4e-10

        .ifdef  test_n
        .equ    n, test_n
        .else
        .equ    n, 2 + draw % 150
        .endif

; As in test-queue.s, quartic i has one root a.  Every tenth is s^4 - a^4, the others are
; (s - a) (s^3 + s / 4 + r).
        .macro  coefficient i, slow, fast
        .if     (\i + draw) % 10 == 0
        .word   \slow
        .else
        .word   \fast
        .endif
        .endm

        .macro  of_root i, a, r
        coefficient \i, -power(\a, 4), -\a * \r
        .endm

        .warm
        .data
k0:     .rept   n
        of_root \+, (((\+ * 5 + draw) % 97 + 1) / 100.5), ((1 + (\+ + draw) % 7) / 8.0)
        .endr
k1:     .rept   n
        coefficient \+, 0.0, (1 + (\+ + draw) % 7) / 8.0 - ((\+ * 5 + draw) % 97 + 1) / 402.0
        .endr
k2:     .rept   n
        coefficient \+, 0.0, 0.25
        .endr
k3:     .rept   n
        coefficient \+, 0.0, -((\+ * 5 + draw) % 97 + 1) / 100.5
        .endr
k4:     .rept   n
        .word   1.0
        .endr
want_root:
        .space  n
