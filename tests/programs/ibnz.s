; IBNZ: low 48 bits of R += 1; if not zero go to T + 32 S

        .regs   r10, count, turns, target, halves, one, length, zero

        EX      count, -3
        ES      one, 1
        EX      target, loop
loop:   ADDX    turns, one, turns
        IBNZ    count, [target]
; expect: r10 = 0
; expect: r11 = 3

; T + 32 S; the high 16 bits of the count stay and do not count
        EX      length, -2
        ELEN    length, 5
        EX      target, skipped - 64
        ES      halves, 2
        IBNZ    length, [target, halves]
        ES      length, 0
skipped:
        EX      target, never
        IBNZ    length, [target]        ; now it is zero
        ES      zero, 1
never:
; expect: r15 = X'0005 0000 0000 0000'
; expect: r16 = 1

        EXIT
