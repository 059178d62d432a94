; The clock is compared with the time that the instructions before it take.
; tests: CLOCK
; CLOCK: T := clocks passed so far, as an integer

        CLOCK   r10
        CLOCK   r11
        ES      r12, 5
        CLOCK   r13
        ADDN    r12, r12, r14           ; 5 clocks
        RTOR    r14, r15                ; waits for the result
        CLOCK   r16
        CLOCK   r0
; expect: r10 = 0
; expect: r11 = 1
; expect: r13 = 3
; expect: r16 = 10
; expect: r0 = 0
        EXIT
; expect-flags: X'0000 0000 0000 0000'
