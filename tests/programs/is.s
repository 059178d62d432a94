; IS: low 48 bits of R += I16

        .regs   r10, up, down, wrapped, length, none

        ES      up, 5
        IS      up, 300
; expect: r10 = 305

        ES      down, 5
        IS      down, -6
; expect: r11 = X'0000 FFFF FFFF FFFF'

        EX      wrapped, X'FFFF FFFF FFFF'
        IS      wrapped, 2
; expect: r12 = 1

; the high 16 bits stay, and take no carry
        EX      length, X'FFFF FFFF FFFF'
        ELEN    length, 10
        IS      length, 1
; expect: r13 = X'000A 0000 0000 0000'

        IS      r0, 1
; expect: r0 = 0

        EXIT
