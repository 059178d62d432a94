; ray-by-ray.s - a queue of rays and a sphere, in a scalar loop.

        .include "core.s"

        .ifndef n
        .equ    n, 3                    ; rays in the queue
        .endif

        .data
ox:     .rept   n                       ; O
        .word   0.0
        .endr
oy:     .rept   n
        .word   0.25 * \+
        .endr
oz:     .rept   n
        .word   0.0
        .endr
dx:     .rept   n                       ; D
        .word   0.0
        .endr
dy:     .rept   n
        .word   0.0
        .endr
dz:     .rept   n
        .word   1.0
        .endr
sphere: .word   0.0, 0.5, 4.0, 1.0      ; C and r^2
tin:    .space  n
tout:   .space  n
        .code

        .regs   r10, ox_at, oy_at, oz_at, dx_at, dy_at, dz_at, in_at, out_at
        .regs   r20, i, one, length, x, y, z, u, v, w, b, h, d0, d1, d2
        .regs   r50, center0, center1, center2, radius2, big, minus_big, sphere_at

        EX      sphere_at, sphere
        ELEN    sphere_at, 4
        SWAP    [sphere_at], center0, [r0]
        EX      ox_at, ox
        EX      oy_at, oy
        EX      oz_at, oz
        EX      dx_at, dx
        EX      dy_at, dy
        EX      dz_at, dz
        EX      in_at, tin
        EX      out_at, tout
        load_constant big, 1e30
        load_constant minus_big, -1e30
        ES      i, 0
        ES      one, 1
        EX      length, n

        .kernel sphere
next:   LOD     [ox_at, i], x
        LOD     [oy_at, i], y
        LOD     [oz_at, i], z
        LOD     [dx_at, i], d0
        LOD     [dy_at, i], d1
        LOD     [dz_at, i], d2
        SUBN    center0, x, x
        SUBN    center1, y, y
        SUBN    center2, z, z
        MPYS    x, d0, u
        MPYS    y, d1, v
        MPYS    z, d2, w
        ADDN    u, v, b
        ADDN    b, w, b
        MPYS    b, d0, u
        MPYS    b, d1, v
        MPYS    b, d2, w
        SUBN    u, x, u
        SUBN    v, y, v
        SUBN    w, z, w
        MPYS    u, u, u
        MPYS    v, v, v
        MPYS    w, w, w
        ADDN    u, v, h
        ADDN    h, w, h
        SUBN    radius2, h, h
        RTOR    big, u
        RTOR    minus_big, v
        CFPLT   h, r0, missed
        SQRT    h, h
        SUBN    b, h, u
        ADDN    b, h, v
missed: STO     [in_at, i], u
        STO     [out_at, i], v
        IBXLT   i, one, length, next, i
        .endkernel
        EXIT
