; DBNZ: low 48 bits of R -= 1; if not zero go to T + 32 S

        .regs   r10, count, turns, target, halves, one, length, zero

        ES      count, 3
        ES      one, 1
        EX      target, loop
loop:   ADDX    turns, one, turns
        DBNZ    count, [target]
; expect: r10 = 0
; expect: r11 = 3

; T + 32 S; the high 16 bits of the count stay and do not count
        EX      length, 0
        ELEN    length, 5
        EX      target, skipped - 64
        ES      halves, 2
        DBNZ    length, [target, halves]
        ES      length, 0
skipped:
        ES      length, 1
        ELEN    length, 5
        EX      target, never
        DBNZ    length, [target]        ; now it is zero
        ES      zero, 1
never:
; expect: r15 = X'0005 0000 0000 0000'
; expect: r16 = 1

        EXIT
