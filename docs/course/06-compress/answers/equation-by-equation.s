; equation-by-equation.s - the nearer root of many quadratic equations, a loop with a branch.

        .include "core.s"

        .ifndef n
        .equ    n, 6                    ; the tests define it
        .endif

        .data
a:
        .rept   n
        .word   2.0
        .endr
b:
        .rept   n
        .word   10.0
        .endr
d:
        .rept   n
        .word   4.0 * (float(\+) - 2.0)
        .endr
t:      .space  n
hits:   .space  1                       ; an integer
        .code

        .regs   r10, a_at, b_at, d_at, t_at, address, count, miss
        .regs   r20, i, one, end, x, y, z

        load_constant miss, -1.0
        EX      a_at, a
        EX      b_at, b
        EX      d_at, d
        EX      t_at, t
        ES      count, 0
        ES      i, 0
        ES      one, 1
        ES      end, n
next:   LOD     [d_at, i], x
        CFPLT   x, r0, none
        LOD     [b_at, i], y
        LOD     [a_at, i], z
        SQRT    x, x
        SUBN    y, x, y
        DIVS    y, z, y
        STO     [t_at, i], y
        IS      count, 1
        BIM     go_on
none:   STO     [t_at, i], miss
go_on:  IBXLT   i, one, end, next, i
        EX      address, hits
        STO     [address], count
        EXIT
; expect: [t] = -1.0, -1.0, 5.0, 4.0
; expect: [hits] = 4
