; CONV: C := A contracted to 32 bits: the high 24 bits of the coefficients

        .include "half_vector.inc"

        .regs   r42, whole, short

        .data
a:      .word   1.5, -0.1, 0.3, 5, X'0058 4000 0000 0000'
word:   .word   -200.25
        .bitvector z, n, "10110"
        .code
        descriptor va, a, n
        descriptor vz, z, n
        descriptor short, a, 2
        EX      place, word
        LOD     [place], whole
        ES      once, 1
        ES      by, 1

        into    plain
        CONV    [va], [to]
; expect-halves: [plain] = 1.5, X'E699 9999', X'E84C CCCC', X'1800 0000'
; expect-halves: [plain + 4*32] = X'7000 0000'
        into    broadcast               ; of a whole register
        CONV    whole, [to] ? [vz]
; expect-halves: [broadcast] = -200.25, kept, -200.25, -200.25, kept
        into    offset
        CONV    [va, once], [to, by] ?! [vz]
; expect-halves: [offset] = kept, X'E699 9999', kept, kept, X'7000 0000'
        into    negative                ; in the size of words
        CONV    -|[va]|, [to] ?! [vz]
; expect-halves: [negative] = kept, X'E699 9999', kept, kept, X'6F80 0000'
        into    short_source            ; machine zeros follow
        CONV    [short], [to]
; expect-halves: [short_source] = 1.5, X'E699 9999', 0.0, 0.0, 0.0

; The result lies over the source: each word is read before the half word in
; its place is stored.
        .data
over:   .word   1.0, 2.0, 3.0
        .code
        descriptor va, over, 3
        descriptor to, over, 3
        CONV    [va], [to]
; expect-halves: [over] = 1.0, 2.0, 3.0, 0, X'FFD3 6000', 0

        EXIT
; expect-flags: X'0000 0000 0032 0000'
