; one-line-linked.s - a time step, with only the first line linked.

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
t:      .space  n
        .code

        .regs   r10, address, step, fs, vs, xs, ts

        EX      address, h
        LOD     [address], step
        descriptor fs, f, n
        descriptor vs, v, n
        descriptor xs, x, n
        descriptor ts, t, n
        LINKV
        MPYSV   [fs], step, [ts]
        ADDNV   [ts], [vs], [vs]
        MPYSV   [vs], step, [ts]
        ADDNV   [ts], [xs], [xs]
        EXIT
; expect: [v] = 2.5, 3.0, 3.5
; expect: [x] = 11.25, 11.5, 11.75
