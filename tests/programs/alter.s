; For each condition and alteration of a bit, one word records whether the branch was
; taken and another the value of the bit afterwards.  A wrong bit, condition or
; alteration makes one of them differ.
; tests: BAB BADF BARB

        .include "alter.inc"

        .regs   r130, count, passes, one

; BAB: changes the bit at address A + B as I4 specifies; goes to C if the bit met
; the condition of I4 before the change
        .macro  BAB.one_bit name, bit, how
        .data
cell_\name: .word pattern
        .code
        EX      left, cell_\name + 64
        ES      right, \bit - 64
        BAB     [left, right], [target], \how
        .endm
        .macro  BAB.altered to, name
        EX      place, cell_\name
        LOD     [place], \to
        .endm
        uses    BAB
; It can alter the instructions after it: ES becomes IS.
        ES      r50, 5
        EX      left, BAB.altering + 7
        EX      target, BAB.altering
        BAB     [left], [target], always | to_one
BAB.altering:
        ES      r50, 1
        register_is BAB, r50, 6
        flags_are BAB, X'0000 0000 0000 0000'

; BADF: changes bit A of the data flag register as I4 specifies; goes to C if the
; bit met the condition of I4 before the change
        .macro  BADF.one_bit name, bit, how
        fetch   left, pattern
        fetch   right, \bit
        LSDFR   left, r0
        BADF    right, [target], \how
        .endm
        .macro  BADF.altered to, name
        LSDFR   r0, \to
        .endm
        uses    BADF
; only the low 6 bits of a bit's number are used
        alter   BADF, low_bits, -1, if_one | change, 1, X'4000 0000 0000 0000'
; a divide fault is tested and cleared; the result stays indefinite
        fetch   left, 1.0
        DIVU    left, r0, result
        ES      right, 41
        EX      target, BADF.fault
        ES      taken, 1
        BADF    right, [target], if_one | to_zero
        ES      taken, 0
BADF.fault:
        register_is BADF, taken, 1
        flags_are BADF, X'0000 0000 0002 0000'

; BARB: changes bit B of A as I4 specifies; goes to C if the bit met the condition
; of I4 before the change
        .macro  BARB.one_bit name, bit, how
        fetch   left, pattern
        fetch   right, \bit
        BARB    left, right, [target], \how
        .endm
        .macro  BARB.altered to, name
        RTOR    left, \to
        .endm
        uses    BARB
; only the low 6 bits of a bit's number are used
        alter   BARB, low_bits, -1, if_one | change, 1, X'4000 0000 0000 0000'
; register 0 is 0 and stays 0
        BARB    r0, right, [target], if_one | to_one
; expect: r0 = 0
; A loop of two passes that uses the bit as its counter.
        ES      one, 1
        ES      passes, 0
        ES      count, 0
        EX      target, BARB.again
BARB.again: ADDX    passes, one, passes
        BARB    count, r0, [target], if_zero | change
        register_is BARB, count, 0
        register_is BARB, passes, 2
        flags_are BARB, X'0000 0000 0000 0000'
        EXIT
