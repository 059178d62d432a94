; MPYX: T := low 48 bits of R x S; high 16 bits zero

        .include "scalar.inc"

        two     plain, MPYX, 6, 7
; expect: [plain] = 42

        two     negative, MPYX, -6, 7
; expect: [negative] = X'0000 FFFF FFFF FFD6'

        two     both_negative, MPYX, -6, -7
; expect: [both_negative] = 42

; 2^30 x (2^30 + 5) = 2^60 + 5 x 2^30
        two     cut, MPYX, X'0000 0000 4000 0000', X'0000 0000 4000 0005'
; expect: [cut] = X'0000 0001 4000 0000'

        two     high_bits, MPYX, X'1234 0000 0000 0003', X'FFFF 0000 0000 0005'
; expect: [high_bits] = 15

        MPYX    left, r0, result        ; register 0 is 0
        keep    by_none
; expect: [by_none] = 0
        MPYX    left, right, r0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
