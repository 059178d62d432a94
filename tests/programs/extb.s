; EXTB: T := bits of R, as many as length(S), from bit S on, right-justified

        .include "scalar.inc"

        two     plain, EXTB, X'0123 4567 89AB CDEF', X'0008 0000 0000 0010'
; expect: [plain] = X'0000 0000 0000 0045'

        two     first, EXTB, X'F123 4567 89AB CDEF', X'0004 0000 0000 0000'
; expect: [first] = 15

        two     last, EXTB, X'0123 4567 89AB CDEF', X'0001 0000 0000 003F'
; expect: [last] = 1

        two     odd_place, EXTB, X'0123 4567 89AB CDEF', X'000D 0000 0000 0007'
; expect: [odd_place] = X'0000 0000 0000 1234'

        two     whole, EXTB, X'7000 4567 89AB CDEF', X'0040 0000 0000 0000'
; expect: [whole] = X'7000 4567 89AB CDEF'

        two     nothing, EXTB, X'FFFF FFFF FFFF FFFF', X'0000 0000 0000 0040'
; expect: [nothing] = 0

        EXTB    left, r0, result        ; register 0 is a field of no bits
        keep    register_zero
; expect: [register_zero] = 0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
