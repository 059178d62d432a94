        ADDN    r0, r0, r11             ; flag 43: machine zero
        LSDFR   r0, r12
        EXIT
; expect: r12 = 1 << 20
; expect-flags: X'0'
