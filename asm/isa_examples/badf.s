        ADDN    r0, r0, r11             ; flag 43: machine zero
        ES      r10, 43
        EX      r12, there
        BADF    r10, [r12], 10          ; branch on one; set to zero
        ES      r13, 1                  ; skipped
there:  EXIT
; expect-flags: X'0'
; expect: r13 = X'0'
