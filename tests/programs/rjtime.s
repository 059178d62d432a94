; The job interval timer is compared with the clocks left after each instruction.
; tests: RJTIME
; RJTIME: T := clocks left on the job interval timer, 0 when off or expired

        .regs   r10, clocks, first, second, third

        RJTIME  r20                     ; off
; expect: r20 = 0
        ES      clocks, 20
        WJTIME  clocks
        RJTIME  first
        RJTIME  second
        ADDN    r0, clocks, r21         ; 5 clocks
        RTOR    r21, r22                ; waits for the result
        RJTIME  third
        RJTIME  r0
; expect: first = 19
; expect: second = 18
; expect: third = 11
; expect: r0 = 0
; the value after the time has expired
        ES      clocks, 2
        WJTIME  clocks
        RJTIME  r23
        RJTIME  r24
        RJTIME  r25
; expect: r23 = 1
; expect: r24 = 0
; expect: r25 = 0
        EXIT
; expect-flags: X'0000 0000 0800 0000'
