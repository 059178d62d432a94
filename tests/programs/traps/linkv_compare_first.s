; The first makes numbers, not bits.
        .include "../vector.inc"
        .data
a:      .word   1.0, 2.0, 3.0, 4.0, 5.0, 6.0
scalars:
        .word   8.0, -0.5
        .bitvector z, n, "101100"
kept:   .word   9.0, 9.0, 9.0, 9.0, 9.0, 9.0
        .code
        operands
        descriptor from, kept, n
        into    nothing
        LINKV
        CMPGEV  [va], x, [from]
        ANDV    [from], y, [to]
; expect-trap: bad-link
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [kept] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
