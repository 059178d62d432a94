; INSB: bits of T, as many as length(S), from bit S on, := low bits of R

        .include "scalar.inc"
        .include "core.s"

        .macro  insert name, bits, field
        fetch   left, \bits
        fetch   right, \field
        load_constant result, X'0123 4567 89AB CDEF'
        INSB    left, right, result
        keep    \name
        .endm

        insert  plain, X'FFFF FFFF FFFF FFA5', X'0008 0000 0000 0010'
; expect: [plain] = X'0123 A567 89AB CDEF'

        insert  first, 0xF, X'0004 0000 0000 0000'
; expect: [first] = X'F123 4567 89AB CDEF'

        insert  last, 0, X'0001 0000 0000 003F'
; expect: [last] = X'0123 4567 89AB CDEE'

        insert  odd_place, 0, X'000D 0000 0000 0007'
; expect: [odd_place] = X'0000 0567 89AB CDEF'

        insert  whole, X'7000 0000 0000 0000', X'0040 0000 0000 0000'
; expect: [whole] = X'7000 0000 0000 0000'

        insert  nothing, -1, X'0000 0000 0000 0040'
; expect: [nothing] = X'0123 4567 89AB CDEF'

        INSB    left, right, r0
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
