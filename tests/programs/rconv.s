; RCONV: C := A contracted to 32 bits, the coefficients rounded, a half upwards

        .include "half_vector.inc"

        .regs   r42, whole, short

        .data
a:      .word   1.5, -0.1, 0.3, X'0000 0000 0080 0000', X'FFD1 7FFF FFFF FFFF'
word:   .word   X'0057 7FFF FFFF FFFF'
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
        RCONV   [va], [to]
; expect-halves: [plain] = 1.5, X'E699 999A', X'E84C CCCD', X'1800 0001', 1.0
        into    broadcast               ; of a whole register; out of range
        RCONV   whole, [to] ? [vz]
; expect-halves: [broadcast] = X'7000 0000', kept, X'7000 0000', X'7000 0000'
; expect-halves: [broadcast + 4*32] = kept
        into    offset
        RCONV   [va, once], [to, by] ?! [vz]
; expect-halves: [offset] = kept, X'E699 999A', kept, kept, 1.0
        into    negative                ; a half upwards is one towards zero
        RCONV   -[va], [to]
; expect-halves: [negative] = -1.5, 0.1, X'E8B3 3333', X'1800 0000', -1.0
        into    short_source            ; machine zeros follow
        RCONV   [short], [to]
; expect-halves: [short_source] = 1.5, X'E699 999A', 0.0, 0.0, 0.0

        EXIT
; expect-flags: X'0000 0000 0032 0000'
