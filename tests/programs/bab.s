; BAB: if the bit at address A + B is as I4 says go to C; alter it as I4 says

        .include "alter.inc"

        .macro  one_bit name, word, bit, how
        .data
cell_\name: .word \word
        .code
        EX      left, cell_\name + 64
        ES      right, \bit - 64
        BAB     [left, right], [target], \how
        .endm

        .macro  altered_word to, name
        EX      place, cell_\name
        LOD     [place], \to
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

; It may alter the instructions that follow: ES becomes IS.
        ES      r50, 5
        EX      left, altering + 7
        EX      target, altering
        BAB     [left], [target], always | to_one
altering:
        ES      r50, 1
; expect: r50 = 6

        EXIT
; expect-flags: X'0000 0000 0000 0000'
