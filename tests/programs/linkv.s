; Results of linked pairs are compared with those of the two instructions in sequence:
; control vectors, offsets, short sources, signs, a recurrence.  Storing the linked
; operand, or reading an operand at the wrong time, makes a word differ.
; tests: LINKV
; warns: recurrence LINKV
; LINKV: the next two vector instructions run as one stream; the first one's
; result is an operand of the second and is not stored

        .include "vector.inc"

        .regs   r40, t

        .data
a:      .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
b:      .word   10.0, 0.5, -3.0, 4.5, 2.0, -0.25
scalars:
        .word   8.0, -0.5
kept:   .word   9.0, 9.0, 9.0, 9.0, 9.0, 9.0
        .code
        operands_of_two
        descriptor t, kept, n
        into    triad                   ; x a + b
        LINKV
        MPYSV   [va], x, [t]
        ADDNV   [t], [vb], [to]
; expect: [triad] = 18.0, -15.5, 21.0, 40.5, -2.0, 799.75
; expect: [kept] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
        into    scaled_sum              ; (a + b) y
        LINKV
        ADDNV   [va], [vb], [t]
        MPYSV   [t], y, [to]
; expect: [scaled_sum] = -5.5, 0.75, 0.0, -4.5, -0.75, -49.875
        into    second_source           ; b - x a
        LINKV
        MPYSV   [va], x, [t]
        SUBNV   [vb], [t], [to]
; expect: [second_source] = 2.0, 16.5, -27.0, -31.5, 6.0, -800.25
        into    controlled              ; only the second has a control vector
        LINKV
        MPYSV   [va], x, [t]
        ADDNV   [t], [vb], [to] ? [vz]
; expect: [controlled] = 18.0, 9.0, 21.0, 40.5, 9.0, 9.0
        into    short_source            ; each continued as its operation says
        LINKV
        MPYSV   [short_a], x, [t]
        ADDNV   [t], [short_b], [to]
; expect: [short_source] = 18.0, -15.5, 24.0, 36.0, 8.0, 8.0
        into    signs                   ; -|x a| + b
        LINKV
        MPYSV   [va], x, [t]
        ADDNV   -|[t]|, [vb], [to]
; expect: [signs] = 2.0, -15.5, -27.0, -31.5, -2.0, -800.25
        into    square                  ; (a + b)^2: both sources are the same
        LINKV
        ADDNV   [va], [vb], [t]
        MPYSV   [t], [t], [to]
; expect: [square] = 121.0, 2.25, 0.0, 81.0, 2.25, 9950.0625
        into    with_offset             ; offsets the result and its control vector
        ELEN    t, n - 1
        LINKV
        MPYSV   [va], x, [t]
        ADDNV   [t], [vb], [to, by] ? [vz]
; expect: [with_offset] = 9.0, 9.0, -15.5, 21.0, 9.0, 9.0
        into    nothing, 0
        ELEN    t, 0                    ; both lengths are equal
        LINKV
        MPYSV   [va], x, [t]
        ADDNV   [t], [vb], [to]
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; a recurrence: the result starts one word after the source
        .data
chain:  .word   1.0, 2.0, 3.0, 4.0
        .code
        descriptor from, chain, 3
        descriptor to, chain + 64, 3
        ELEN    t, 3
        LINKV
        MPYSV   [from], x, [t]
        ADDNV   [t], y, [to]
; expect: [chain] = 1.0, 7.5, 59.5, 475.5
        EXIT
; expect-flags: X'0000 0000 0010 0000'
; expect-warning: zero-length
; expect-warning: recurrence
