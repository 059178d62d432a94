; IX: low 48 bits of R += I48

        ES      r10, 5
        IX      r10, X'1000 0000 0000'
; expect: r10 = X'0000 1000 0000 0005'

        ES      r11, 5
        IX      r11, -6
; expect: r11 = X'0000 FFFF FFFF FFFF'

; the high 16 bits stay, and take no carry: a descriptor moves on by a word
        EX      r12, X'FFFF FFFF FFFF'
        ELEN    r12, 10
        IX      r12, 65
; expect: r12 = X'000A 0000 0000 0040'

        IX      r0, 1
; expect: r0 = 0

        EXIT
