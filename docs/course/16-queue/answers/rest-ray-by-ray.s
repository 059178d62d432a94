; rest-ray-by-ray.s - the rays that hit a scene, and their depth: intersections in
; vectors; the queue is filled and used ray by ray.
;
; Ray k runs along z from (x, y, 0), where x and y are the fractions of k STEP_X and k STEP_Y.
; For each sphere that it hits it computes the nearer point,
;
;   h = r^2 - (x - cx)^2 - (y - cy)^2,   z = cz - sqrt(h)   if h >= 0
;
; and the minimum z.  seen counts the rays with a hit, depth is the sum of their z.

        .include "core.s"

        .ifndef rays
        .equ    rays, 1000
        .equ    queue, 100              ; rays in the queue
        .equ    bodies, 2
        .endif
        .equ    STEP_X, 648056.0 / 1048576
        .equ    STEP_Y, 434334.0 / 1048576

        .data
spheres:                                ; cx, cy, cz, r^2 of each
        .rept   bodies
        .word   0.3, 0.4, 2.0 + \+, 0.05
        .endr
seen:   .word   0.0
depth:  .word   0.0
xs:     .space  queue
ys:     .space  queue
nearest:
        .space  queue
us:     .space  queue
ss:     .space  queue
        .bitvector meets, queue
        .bitvector nearers, queue
        .code

        .regs   r10, left, length, body, body_at, next_body, place, record
        .regs   r20, cx, cy, cz, radius2
        .regs   r30, x, y, near, u, s, handed, bits, nearer
        .regs   r50, step_x, step_y, ray_x, ray_y, one, big
        .regs   r60, x_at, y_at, word, z, sum, count, total

        load_constant step_x, STEP_X
        load_constant step_y, STEP_Y
        load_constant ray_x, 0.0
        load_constant ray_y, 0.0
        load_constant one, 1.0
        load_constant big, 1e30
        load_constant sum, 0.0
        load_constant total, 0.0
        EX      word, 64
        EX      left, rays
        EX      record, 4 * 64
        EX      next_body, a_body
        EX      length, queue

        .macro  vector name, address
        EX      \name, \address
        ADDLEN  \name, length, \name
        .endm

a_queue:
        .kernel make
        IBXGE   left, r0, length, full
        RTOR    left, length            ; the last queue
full:   vector  x, xs
        vector  y, ys
        vector  u, us
        vector  s, ss
        vector  handed, us              ; not stored
        vector  near, nearest
        vector  bits, meets
        vector  nearer, nearers
        RTOR    x, x_at
        RTOR    y, y_at
        RTOR    length, count
        EX      place, fill
fill:   STO     [x_at], ray_x
        STO     [y_at], ray_y
        ADDX    x_at, word, x_at
        ADDX    y_at, word, y_at
        ADDN    ray_x, step_x, ray_x
        ADDN    ray_y, step_y, ray_y
        CFPLT   ray_x, one, x_is_fraction
        SUBN    ray_x, one, ray_x
x_is_fraction:
        CFPLT   ray_y, one, y_is_fraction
        SUBN    ray_y, one, ray_y
y_is_fraction:
        DBNZ    count, [place]
        VTOV    big, [near]
        .endkernel

        .kernel intersect
        EX      body_at, spheres
        ELEN    body_at, 4
        ES      body, bodies
a_body: SWAP    [body_at], cx, [r0]
        ADDX    body_at, record, body_at
        LINKV
        SUBNV   [x], cx, [handed]
        MPYSV   [handed], [handed], [s]
        LINKV
        SUBNV   [y], cy, [handed]
        MPYSV   [handed], [handed], [u]
        ADDNV   [s], [u], [s]
        CMPGEV  radius2, [s], [bits]
        SUBNV   radius2, [s], [s]
        SQRTV   [s], [s] ? [bits]
        SUBNV   cz, [s], [s]
        CMPGEV  [s], [near], [nearer]
        ANDNB   [bits], [nearer], [bits]
        VTOV    [s], [near] ? [bits]
        DBNZ    body, [next_body]
        .endkernel

        .kernel use
        RTOR    near, x_at
        RTOR    length, count
        EX      place, pick
pick:   LOD     [x_at], z
        ADDX    x_at, word, x_at
        CFPGE   z, big, unseen
        ADDN    total, one, total
        ADDN    sum, z, sum
unseen: DBNZ    count, [place]
        SUBX    left, length, left
        IBXNE   left, r0, r0, again
        EX      place, seen
        STO     [place], total
        EX      place, depth
        STO     [place], sum
        EXIT
again:  BIM     a_queue
        .endkernel
