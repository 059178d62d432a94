; Counts and links are compared with those of the path that the branches must take.  A
; wrong target, link or count makes a word differ, or the program does not end.
; tests: BIM BSAVE DBNZ IBNZ

        .include "keep.inc"

        .regs   r130, passed, offset, link, target, sum, two, halves, here, count
        .regs   r139, turns, one, length, zero

        ES      sum, 0
        ES      turns, 0

; BIM: go to I48 + R
        BIM     BIM.first
        ES      passed, -1
BIM.first: IS      passed, 1
        ES      offset, 64
        BIM     BIM.second - 64, offset
        ES      passed, -1
BIM.second: IS      passed, 1
; only the low 48 bits of R are used; they may be negative
        EX      offset, -32
        ELEN    offset, 9
        BIM     BIM.third + 32, offset
        ES      passed, -1
BIM.third: IS      passed, 1
        register_is BIM, passed, 3
; BSAVE: R := address of the next instruction; go to T + 32 S
; a call and its return, twice
        ES      two, 2
        EX      target, BSAVE.routine
        BSAVE   link, [target]
BSAVE.first_return:
        EX      target, BSAVE.routine - 96
        ES      halves, 3
        BSAVE   link, [target, halves]
BSAVE.second_return:
        register_is BSAVE, sum, 4
        register_is BSAVE, link, BSAVE.second_return
; the target may be in the register that receives the link
        EX      here, BSAVE.past
        BSAVE   here, [here]
BSAVE.linked: ES      sum, 0
BSAVE.past:
        register_is BSAVE, here, BSAVE.linked
        EX      target, BSAVE.last
        BSAVE   r0, [target]            ; no link is kept
        ES      sum, 0
BSAVE.last:
; expect: r0 = 0
; DBNZ: low 48 bits of R -= 1; if they are not zero, go to T + 32 S
        ES      count, 3
        ES      one, 1
        EX      target, DBNZ.loop
DBNZ.loop: ADDX    turns, one, turns
        DBNZ    count, [target]
        register_is DBNZ, count, 0
        register_is DBNZ, turns, 3
; the target is T + 32 S; the high 16 bits of the count are kept and ignored
        EX      length, 0
        ELEN    length, 5
        EX      target, DBNZ.skipped - 64
        ES      halves, 2
        DBNZ    length, [target, halves]
        ES      length, 0
DBNZ.skipped:
        ES      length, 1
        ELEN    length, 5
        EX      target, DBNZ.never
        DBNZ    length, [target]        ; now it is zero
        ES      zero, 1
DBNZ.never:
        register_is DBNZ, length, X'0005 0000 0000 0000'
        register_is DBNZ, zero, 1
; IBNZ: low 48 bits of R += 1; if they are not zero, go to T + 32 S
        EX      count, -3
        ES      turns, 0
        ES      zero, 0
        ES      one, 1
        EX      target, IBNZ.loop
IBNZ.loop:
        ADDX    turns, one, turns
        IBNZ    count, [target]
        register_is IBNZ, count, 0
        register_is IBNZ, turns, 3
; the target is T + 32 S; the high 16 bits of the count are kept and ignored
        EX      length, -2
        ELEN    length, 5
        EX      target, IBNZ.skipped - 64
        ES      halves, 2
        IBNZ    length, [target, halves]
        ES      length, 0
IBNZ.skipped:
        EX      target, IBNZ.never
        IBNZ    length, [target]        ; now it is zero
        ES      zero, 1
IBNZ.never:
        register_is IBNZ, length, X'0005 0000 0000 0000'
        register_is IBNZ, zero, 1
        EXIT
BSAVE.routine:
        ADDX    sum, two, sum
        BSAVE   r0, [link]
