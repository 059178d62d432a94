; Results of linked pairs on half words are compared with results worked out by hand.  A
; wrong size of the linked operand, or storing it, makes one differ.
; Linked pairs on half words.

        .include "half_vector.inc"

        .reg    t, r50
        five    a, 1.0, -2.0, 3.0, 4.5, -0.5
        five    b, 10.0, 0.5, -3.0, 4.5, 2.0
        some_scalars 8.0, -0.5
        five    handed, kept, kept, kept, kept, kept
        .code
        operands
        descriptor t, handed, n
        into    triad                   ; x a + b
        LINKV
        MPYSV,H [va], x, [t]
        ADDNV,H [t], [vb], [to]
; expect-halves: [triad] = 18.0, -15.5, 21.0, 40.5, -2.0
; expect-halves: [handed] = kept, kept, kept, kept, kept
        into    scaled_sum              ; (a + b) y
        LINKV
        ADDNV,H [va], [vb], [t]
        MPYSV,H [t], y, [to] ? [vz]
; expect-halves: [scaled_sum] = -5.5, kept, 0.0, -4.5, kept
        into    second_source           ; b - x a
        LINKV
        MPYSV,H [va], x, [t]
        SUBNV,H [vb], [t], [to]
; expect-halves: [second_source] = 2.0, 16.5, -27.0, -31.5, 6.0
        into    short_source            ; ones, then machine zeros follow
        ELEN    vb, 2
        LINKV
        MPYSV,H [short_a], x, [t]
        ADDNV,H [t], [vb], [to]
; expect-halves: [short_source] = 18.0, -15.5, 24.0, 8.0, 8.0
; a recurrence: the result starts one half word after the source
        odd
chain:  .halfword 1.0, 2.0, 3.0, 4.0
        .code
        descriptor from, chain, 3
        descriptor to, chain + 32, 3
        ELEN    t, 3
        LINKV
        MPYSV,H [from], x, [t]
        ADDNV,H [t], y, [to]
; expect-halves: [chain] = 1.0, 7.5, 59.5, 475.5
        EXIT
; expect-flags: X'0000 0000 0010 0000'
; expect-warning: recurrence
