; The timer and its data flag are compared after it is set, set again and turned off.
; tests: WJTIME
; WJTIME: job interval timer := low 48 bits of R, in clocks; 0 turns the timer
; off

        .regs   r10, clocks, left, flags

        ES      clocks, 100
        ELEN    clocks, 7               ; only the low 48 bits count
        WJTIME  clocks
        RJTIME  left
; expect: left = 99
        ES      clocks, 5
        WJTIME  clocks                  ; a new time in place of the old one
        ES      r20, 1
        LSDFR   r0, flags               ; the time has not expired
; expect: flags = 0
        ES      r20, 2
        ES      r20, 3
        ES      r20, 4
        LSDFR   r0, r21                 ; the time has expired
; expect: r21 = X'0000 0000 0800 0000'
; the timer is turned off before the time expires
        ES      clocks, 3
        WJTIME  clocks
        WJTIME  r0
        ES      r20, 5
        ES      r20, 6
        ES      r20, 7
        RJTIME  r22
; expect: r22 = 0
        EXIT
; expect-flags: X'0000 0000 0000 0000'
