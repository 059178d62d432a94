; The bit lies in no page.
        EX      r10, next
        EX      r11, 0x7FFFFFFF
        BAB     [r11], [r10], 3
next:   ES      r12, 5
; expect-trap: unmapped-address
; expect: r12 = 0
