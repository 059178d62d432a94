; EXTH: T := R extended to 64 bits

        .include "half.inc"

        .macro  extends name, r
        .data
\name:  .word   9.0
        .code
        fetch   left, \r
        EXTH    left, r40
        EX      place, \name
        STO     [place], r40
        .endm

        extends plain, 1.5
; expect: [plain] = 1.5
        extends negative, -200.25
; expect: [negative] = -200.25
        extends tenth, 0.1
; expect: [tenth] = X'FFCE 6666 6600 0000'

; exact, and not normalised
        extends integer, 5
; expect: [integer] = X'FFE8 0000 0500 0000'
        extends minus_one, -1
; expect: [minus_one] = X'FFE8 FFFF FF00 0000'
        extends zero_coefficient, X'1000 0000'
; expect: [zero_coefficient] = X'FFF8 0000 0000 0000'
        extends largest, X'6F7F FFFF'
; expect: [largest] = X'0057 7FFF FF00 0000'
        extends smallest, X'9040 0000'
; expect: [smallest] = X'FF78 4000 0000 0000'

; specials become the plain words
        extends zero, X'8012 3456'
; expect: [zero] = 0.0
        extends indefinite, X'7012 3456'
; expect: [indefinite] = X'7000 0000 0000 0000'

; h0 and h1 are machine zero
        EXTH    h0, r41
        EXTH    h1, r42
        EXTH    left, r0
; expect: r41 = 0.0
; expect: r42 = 0.0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0012 0000'
