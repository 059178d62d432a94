; ES: R := I16, sign extended to 48 bits; high 16 bits zero

        EX      r11, -1                 ; whatever was there is gone
        ES      r10, 5
        ES      r11, -2
        ES      r12, 32767
        ES      r13, -32768
; expect: r10 = 5
; expect: r11 = X'0000 FFFF FFFF FFFE'
; expect: r12 = 32767
; expect: r13 = X'0000 FFFF FFFF 8000'

; nothing is kept in register 0
        ES      r0, 7
; expect: r0 = 0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
