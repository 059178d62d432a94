; SUBX: T := low 48 bits of R - S; high 16 bits from R

        .include "scalar.inc"

        two     plain, SUBX, 12, 7
; expect: [plain] = 5

        two     negative, SUBX, 5, 7
; expect: [negative] = X'0000 FFFF FFFF FFFE'

        two     minus_negative, SUBX, 5, -7
; expect: [minus_negative] = 12

; a descriptor keeps its length
        two     moved, SUBX, X'0064 0000 0000 1040', X'FFFF 0000 0000 0040'
; expect: [moved] = X'0064 0000 0000 1000'

        two     no_borrow, SUBX, X'0001 0000 0000 0000', 1
; expect: [no_borrow] = X'0001 FFFF FFFF FFFF'

        SUBX    r0, right, result       ; register 0 is 0
        keep    from_none
; expect: [from_none] = X'0000 FFFF FFFF FFFF'
        SUBX    left, right, r0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
