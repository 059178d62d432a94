; Both instructions have operands of one size.
        .include "../half_vector.inc"
        .data
a:      .word   1.0, 2.0, 3.0, 4.0, 5.0
        .code
        descriptor va, a, n
        descriptor from, a, n
        into    nothing
        LINKV
        MPYSV   [va], r40, [from]
        ADDNV,H [from], [va], [to]
; expect-trap: bad-link
; expect-halves: [nothing] = kept, kept, kept, kept, kept
; expect: [a] = 1.0, 2.0, 3.0, 4.0, 5.0
; expect-warning: unwritten-register
