; Bit fields extracted from a word, or inserted into one, are compared with words worked
; out by hand: first and last bit, whole word, empty field.  A wrong position or length,
; or a changed bit outside the field, makes a word differ.
; tests: EXTB INSB

        .include "scalar.inc"
        .include "core.s"

; EXTB: T := the bit field of R that S describes, right-justified
        two     EXTB, plain, X'0123456789ABCDEF', X'0008000000000010', X'0000000000000045'
        two     EXTB, first, X'F123 4567 89AB CDEF', X'0004 0000 0000 0000', 15
        two     EXTB, last, X'0123 4567 89AB CDEF', X'0001 0000 0000 003F', 1
        two     EXTB, odd_place, X'0123456789ABCDEF', X'000D000000000007', X'0000000000001234'
        two     EXTB, whole, X'7000456789ABCDEF', X'0040000000000000', X'7000456789ABCDEF'
        two     EXTB, nothing, X'FFFF FFFF FFFF FFFF', X'0000 0000 0000 0040', 0
        EXTB    left, r0, result        ; register 0 is a field of no bits
        word_is EXTB, register_zero, 0
        flags   EXTB, X'0000 0000 0000 0000'

; INSB: the bit field of T that S describes := low bits of R
        .macro  insert name, bits, field, want
        fetch   left, \bits
        fetch   right, \field
        load_constant result, X'0123 4567 89AB CDEF'
        INSB    left, right, result
        word_is INSB, \name, \want
        .endm
        insert  plain, X'FFFFFFFFFFFFFFA5', X'0008000000000010', X'0123A56789ABCDEF'
        insert  first, 0xF, X'0004 0000 0000 0000', X'F123 4567 89AB CDEF'
        insert  last, 0, X'0001 0000 0000 003F', X'0123 4567 89AB CDEE'
        insert  odd_place, 0, X'000D 0000 0000 0007', X'0000 0567 89AB CDEF'
        insert  whole, X'7000000000000000', X'0040000000000000', X'7000000000000000'
        insert  nothing, -1, X'0000 0000 0000 0040', X'0123 4567 89AB CDEF'
        INSB    left, right, r0
; expect: r0 = 0
        flags   INSB, X'0000 0000 0000 0000'
        EXIT
