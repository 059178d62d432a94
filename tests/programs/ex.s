; EX: R := I48; high 16 bits zero

        .data
place:  .word   42
        .code

        EX      r10, X'1234 5678 9ABC'
        EX      r11, -1
        EX      r12, place
        LOD     [r12], r13
        EX      r0, 5
; expect: r10 = X'0000 1234 5678 9ABC'
; expect: r11 = X'0000 FFFF FFFF FFFF'
; expect: r12 = place
; expect: r13 = 42
; expect: r0 = 0

        EXIT
