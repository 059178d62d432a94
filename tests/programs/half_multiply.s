; Products and quotients of half word vectors are compared with half words worked out by
; hand. A wrong coefficient, number of significant bits or size of an element makes one
; differ.
; Vectors of half words: multiply, divide.

        .include "half_vector.inc"

        five    a, 1.0, -2.0, 3.0, 4.5, -0.5
        five    b, 10.0, 0.5, -3.0, 4.5, 2.0
        some_scalars 8.0, -0.5
        odd
uneven_a:
        .halfword 0.1, 6, -1, X'007F FFFF', X'7012 3456'
        five    uneven_b, -0.3, 7, -1, X'007F FFFF', 1.0
        .code
        operands
        all_uses MPYSV
; expect-halves: [MPYSV.plain] = 10.0, -1.0, -9.0, 20.25, -1.0
; expect-halves: [MPYSV.broadcast] = 80.0, kept, -24.0, 36.0, kept
; expect-halves: [MPYSV.offset] = kept, 1.0, kept, kept, 0.25
; expect-halves: [MPYSV.short] = -10.0, -1.0, 9.0, 4.5, 2.0
        both_uses MPYUV
; expect-halves: [MPYUV.plain] = X'EE280000', X'EAC00000', -9.0, X'EF288000', X'EAC00000'
; expect-halves: [MPYUV.broadcast] = X'F1280000', kept, X'EFD00000', X'F0240000', kept
        all_uses DIVSV
; expect-halves: [DIVSV.plain] = 0.1, -4.0, -1.0, 1.0, -0.25
; expect-halves: [DIVSV.broadcast] = 0.8, kept, X'EBAA AAAB', X'EA71 C71C', kept
; expect-halves: [DIVSV.offset] = kept, 4.0, kept, kept, 1.0
; expect-halves: [DIVSV.short] = X'E699 999A', -4.0, 1.0, X'E771 C71C', 0.5
        makes   DIVUV, 0.1, -4.0, -1.0, 1.0, -0.25, 0.8, X'EBAA AAAB', X'EA71 C71C'
        descriptor va, uneven_a, n
        descriptor vb, uneven_b, n
        plain   MPYLV
; expect-halves: [MPYLV.plain] = X'CE1E B852', 42, 1, 1, X'7000 0000'
        EXIT
; expect-flags: X'0000 0000 0002 0000'
