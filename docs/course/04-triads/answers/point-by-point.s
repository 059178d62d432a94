; point-by-point.s - a time step, a loop over the points.

        .include "core.s"

        .ifndef n
        .equ    n, 10                   ; the tests define it
        .endif

        .data
h:      .word   0.5                     ; the time step
f:
        .rept   n
        .word   1.0 + float(\+)
        .endr
v:
        .rept   n
        .word   2.0
        .endr
x:
        .rept   n
        .word   10.0
        .endr
        .code

        .regs   r10, address, step, f_at, v_at, x_at
        .regs   r20, i, one, count, force, speed, place, change

        EX      address, h
        LOD     [address], step
        EX      f_at, f
        EX      v_at, v
        EX      x_at, x
        ES      i, 0
        ES      one, 1
        ES      count, n
next:   LOD     [f_at, i], force
        LOD     [v_at, i], speed
        LOD     [x_at, i], place
        MPYS    force, step, change
        ADDN    change, speed, speed
        STO     [v_at, i], speed
        MPYS    speed, step, change
        ADDN    change, place, place
        STO     [x_at, i], place
        IBXLT   i, one, count, next, i
        EXIT
; expect: [v] = 2.5, 3.0, 3.5
; expect: [x] = 11.25, 11.5, 11.75
