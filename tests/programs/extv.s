; EXTV: C := A extended to 64 bits

        .include "half_vector.inc"

        odd
a:      .halfword 1.5, -2.0, 0.1, 5, X'7012 3456'
b:
scalars:
        .halfword -200.25, 0.0
        .code

        operands
        into_words plain
        EXTV    [va], [to]
; expect: [plain] = 1.5, -2.0, X'FFCE 6666 6600 0000', X'FFE8 0000 0500 0000'
; expect: [plain + 4*64] = X'7000 0000 0000 0000'
        into_words broadcast            ; of a half register
        EXTV    x, [to] ? [vz]
; expect: [broadcast] = -200.25, kept, -200.25, -200.25, kept
        into_words offset
        EXTV    [va, once], [to, by] ?! [vz]
; expect: [offset] = kept, -2.0, kept, kept, X'7000 0000 0000 0000'
        into_words negative
        EXTV    -|[va]|, [to] ? [vz]
; expect: [negative] = -1.5, kept, X'FFCE 9999 9A00 0000'
; expect: [negative + 3*64] = X'FFE8 FFFF FB00 0000', kept
        into_words short_source         ; machine zeros follow
        EXTV    [short_a], [to]
; expect: [short_source] = 1.5, -2.0, X'FFCE 6666 6600 0000', 0.0, 0.0

; The result lies over the source: a half word is read before the word in its
; place is stored, so the third comes from the second word.
        .data
over:   .halfword 1.0, 2.0, 3.0, 4.0, 5.0, 6.0
        .code
        descriptor va, over, 3
        descriptor to, over, 3
        EXTV    [va], [to]
; expect: [over] = 1.0, X'FFE8 0000 0000 0000', X'FFE7 E800 0000 0000'

        EXIT
; expect-flags: X'0000 0000 0012 0000'
; expect-warning: recurrence
