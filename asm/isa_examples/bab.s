        .data
value:  .word   5
        .code
        EX      r10, value
        ES      r11, 63                 ; the rightmost bit
        EX      r12, there
        BAB     [r10, r11], [r12], 10   ; branch on one; set to zero
        ES      r13, 1                  ; skipped
there:  EXIT
; expect: [value] = 4
; expect: r13 = X'0'
