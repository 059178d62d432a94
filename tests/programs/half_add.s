; Sums, differences and averages of half word vectors are compared with half words
; worked out by hand.  The vectors start in right halves, so a wrong element size or
; address makes one differ.
; Vectors of half words: add, subtract, average.
; warns: recurrence ADDNV,H

        .include "half_vector.inc"

        five    a, 1.0, -2.0, 3.0, 4.5, -0.5
        five    b, 10.0, 0.5, -3.0, 4.5, 2.0
        some_scalars 8.0, -0.5
        odd
uneven_a:
        .halfword 1.0, 0.1, 7, 5, X'7012 3456'
        odd
uneven_b:
        .halfword X'D280 0000', 0.2, 0.0, 3, 1.0
        .code
        operands
        all_uses ADDNV
; expect-halves: [ADDNV.plain] = 11.0, -1.5, 0.0, 9.0, 1.5
; expect-halves: [ADDNV.broadcast] = 18.0, kept, 5.0, 12.5, kept
; expect-halves: [ADDNV.offset] = kept, -2.5, kept, kept, -1.0
; expect-halves: [ADDNV.short] = 9.0, -1.5, -6.0, 4.5, 2.0
        all_uses ADDUV
; expect-halves: [ADDUV.plain] = 11.0, -1.5, X'EB00 0000', 9.0, X'EB30 0000'
; expect-halves: [ADDUV.broadcast] = 18.0, kept, X'ED28 0000', 12.5, kept
; expect-halves: [ADDUV.offset] = kept, -2.5, kept, kept, -1.0
; expect-halves: [ADDUV.short] = 9.0, -1.5, -6.0, 4.5, 2.0
        makes   SUBNV, -9.0, -2.5, 6.0, 0.0, -2.5, -2.0, 11.0, 3.5
        makes   SUBUV, -9.0, -2.5, 6.0, X'EC000000', -2.5, X'EDF00000', 11.0, X'ED1C0000'
        makes   AVGV, 5.5, -0.75, 0.0, 4.5, 0.75, 9.0, 2.5, 6.25
        makes   AVGDV, -4.5, -1.25, 3.0, 0.0, -1.25, -1.0, 5.5, 1.75
; Lower halves of sums: of a tiny number that is lost in the upper half, and of
; 0.1 + 0.2.  Sums with machine zero and sums of integers have no lower half.
        descriptor va, uneven_a, n
        descriptor vb, uneven_b, n
        plain   ADDLV
; expect-halves: [ADDLV.plain] = X'D340 0000', X'D140 0000', X'E900 0000', X'E900 0000', X'7000 0000'
        plain   SUBLV
; expect-halves: [SUBLV.plain] = X'D340 0000', X'D000 0000', X'E900 0000', X'E900 0000', X'7000 0000'
; The result starts one half word after the first source, so each element is
; computed from the element before it.
        odd
chain:  .halfword 1.0, kept, kept, kept, kept, kept
        .code
        descriptor from, chain, n
        descriptor to, chain + 32, n
        descriptor vb, b, n
        ADDNV,H [from], [vb], [to]
; expect-halves: [chain] = 1.0, 11.0, 11.5, 8.5, 13.0, 15.0
        EXIT
; expect-flags: X'0000 0000 0012 0000'
; expect-warning: recurrence
