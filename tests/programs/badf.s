; BADF: if bit A of the data flag register is as I4 says go to C; alter it as
; I4 says

        .include "alter.inc"

        .macro  one_bit name, word, bit, how
        fetch   left, \word
        fetch   right, \bit
        LSDFR   left, r0
        BADF    right, [target], \how
        .endm

        .macro  altered_word to, name
        LSDFR   r0, \to
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

; a divide fault seen and cleared; the result stays indefinite
        fetch   left, 1.0
        DIVU    left, r0, result
        ES      right, 41
        EX      target, fault
        ES      taken, 1
        BADF    right, [target], if_one | to_zero
        ES      taken, 0
fault:  keep_taken fault_seen
; expect: [fault_seen] = 1

        EXIT
; expect-flags: X'0000 0000 0002 0000'
