; ELEN: length field of R := I16

        EX      r10, X'1234 5678 9ABC'
        ELEN    r10, 1000
; expect: r10 = X'03E8 1234 5678 9ABC'

        ELEN    r11, 65535              ; the longest vector
; expect: r11 = X'FFFF 0000 0000 0000'

        EX      r12, -1
        ELEN    r12, 7
        ELEN    r12, 0
; expect: r12 = X'0000 FFFF FFFF FFFF'

        ELEN    r0, 3
; expect: r0 = 0

        EXIT
