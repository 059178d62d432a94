; Vectors contracted to half words, or extended, are compared with results worked out by
; hand, for every use and for results that overlap their sources.  A wrong rounding,
; element size, order or data flag makes a word differ.
; tests: CONV RCONV EXTV
; warns: recurrence EXTV

        .include "half_vector.inc"

        .regs   r200, whole, short

; CONV: C := A contracted to 32 bits: the high 24 bits of the coefficients
        .data
CONV.a: .word   1.5, -0.1, 0.3, 5, X'0058 4000 0000 0000'
CONV.word: .word   -200.25
CONV.over: .word   1.0, 2.0, 3.0
        .code
        descriptor va, CONV.a, n
        descriptor vz, z, n
        descriptor short, CONV.a, 2
        EX      place, CONV.word
        LOD     [place], whole
        ES      once, 1
        ES      by, 1
        of_one  CONV, plain, [va], [to]
; expect-halves: [CONV.plain] = 1.5, X'E6999999', X'E84CCCCC', X'18000000', X'70000000'
        of_one  CONV, broadcast, whole, [to] ? [vz] ; of a whole register
; expect-halves: [CONV.broadcast] = -200.25, kept, -200.25, -200.25, kept
        of_one  CONV, offset, [va, once], [to, by] ?! [vz]
; expect-halves: [CONV.offset] = kept, X'E699 9999', kept, kept, X'7000 0000'
        of_one  CONV, negative, -|[va]|, [to] ?! [vz] ; the sign is applied to words
; expect-halves: [CONV.negative] = kept, X'E699 9999', kept, kept, X'6F80 0000'
        of_one  CONV, short_source, [short], [to] ; padded with machine zeros
; expect-halves: [CONV.short_source] = 1.5, X'E699 9999', 0.0, 0.0, 0.0
; The result overlaps the source: each word is read before its half word is stored.
        descriptor va, CONV.over, 3
        descriptor to, CONV.over, 3
        CONV    [va], [to]
; expect-halves: [CONV.over] = 1.0, 2.0, 3.0, 0, X'FFD3 6000', 0
        flags_are CONV, X'0000 0000 0032 0000'
; RCONV: C := A contracted to 32 bits, coefficients rounded to nearest, ties
; upwards
        .data
RCONV.a: .word   1.5, -0.1, 0.3, X'0000 0000 0080 0000', X'FFD1 7FFF FFFF FFFF'
RCONV.word: .word   X'0057 7FFF FFFF FFFF'
        .code
        descriptor va, RCONV.a, n
        descriptor vz, z, n
        descriptor short, RCONV.a, 2
        EX      place, RCONV.word
        LOD     [place], whole
        of_one  RCONV, plain, [va], [to]
; expect-halves: [RCONV.plain] = 1.5, X'E699 999A', X'E84C CCCD', X'1800 0001', 1.0
        of_one  RCONV, broadcast, whole, [to] ? [vz] ; of a whole register; out of range
; expect-halves: [RCONV.broadcast] = X'70000000', kept, X'70000000', X'70000000', kept
        of_one  RCONV, offset, [va, once], [to, by] ?! [vz]
; expect-halves: [RCONV.offset] = kept, X'E699 999A', kept, kept, 1.0
        of_one  RCONV, negative, -[va], [to] ; a half upwards is one towards zero
; expect-halves: [RCONV.negative] = -1.5, 0.1, X'E8B3 3333', X'1800 0000', -1.0
        of_one  RCONV, short_source, [short], [to] ; padded with machine zeros
; expect-halves: [RCONV.short_source] = 1.5, X'E699 999A', 0.0, 0.0, 0.0
        flags_are RCONV, X'0000 0000 0032 0000'
; EXTV: C := A extended to 64 bits
        odd
EXTV.a: .halfword 1.5, -2.0, 0.1, 5, X'7012 3456'
EXTV.b:
EXTV.scalars:
        .halfword -200.25, 0.0
        .code
        operands EXTV.
        into_words EXTV.plain
        EXTV    [va], [to]
; expect: [EXTV.plain] = 1.5, -2.0, X'FFCE666666000000', X'FFE8000005000000', indefinite
        into_words EXTV.broadcast            ; of a half register
        EXTV    x, [to] ? [vz]
; expect: [EXTV.broadcast] = -200.25, kept, -200.25, -200.25, kept
        into_words EXTV.offset
        EXTV    [va, once], [to, by] ?! [vz]
; expect: [EXTV.offset] = kept, -2.0, kept, kept, indefinite
        into_words EXTV.negative
        EXTV    -|[va]|, [to] ? [vz]
; expect: [EXTV.negative] = -1.5, kept, X'FFCE99999A000000', X'FFE8FFFFFB000000', kept
        into_words EXTV.short_source         ; padded with machine zeros
        EXTV    [short_a], [to]
; expect: [EXTV.short_source] = 1.5, -2.0, X'FFCE 6666 6600 0000', 0.0, 0.0
; The result overlaps the source: a half word is read before the word at its
; place is stored, so the third result comes from the second word stored.
        .data
EXTV.over: .halfword 1.0, 2.0, 3.0, 4.0, 5.0, 6.0
        .code
        descriptor va, EXTV.over, 3
        descriptor to, EXTV.over, 3
        EXTV    [va], [to]
; expect: [EXTV.over] = 1.0, X'FFE8 0000 0000 0000', X'FFE7 E800 0000 0000'
        flags_are EXTV, X'0000 0000 0012 0000'
        EXIT
; expect-warning: recurrence
