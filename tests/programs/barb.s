; BARB: if bit B of A is as I4 says go to C; alter it as I4 says

        .include "alter.inc"

        .macro  one_bit name, word, bit, how
        fetch   left, \word
        fetch   right, \bit
        BARB    left, right, [target], \how
        .endm

        .macro  altered_word to, name
        RTOR    left, \to
        .endm

        uses
; expect: [never_leave] = 0, X'4000 0000 0000 0001'
; expect: [never_change] = 0, X'0000 0000 0000 0001'
; expect: [never_zero] = 0, X'4000 0000 0000 0001'
; expect: [never_one] = 0, X'6000 0000 0000 0001'
; expect: [always_leave] = 1, X'4000 0000 0000 0001'
; expect: [always_change] = 1, X'6000 0000 0000 0001'
; expect: [one_zero] = 1, X'0000 0000 0000 0001'
; expect: [one_not] = 0, X'4000 0000 0000 0001'
; expect: [zero_one] = 1, X'6000 0000 0000 0001'
; expect: [zero_not] = 0, X'4000 0000 0000 0001'
; expect: [last] = 1, X'4000 0000 0000 0000'

; only the low 6 bits of a bit's number count
        alter   low_bits, X'4000 0000 0000 0001', -1, if_one | change
; expect: [low_bits] = 1, X'4000 0000 0000 0000'

; register 0 is 0, and stays it
        BARB    r0, right, [target], if_one | to_one
; expect: r0 = 0

; A loop of two passes: the bit is the count.
        .regs   r50, count, passes, one
        ES      one, 1
        EX      target, again
again:  ADDX    passes, one, passes
        BARB    count, r0, [target], if_zero | change
; expect: r50 = 0
; expect: r51 = 2

        EXIT
; expect-flags: X'0000 0000 0000 0000'
