; solution.s - the rays that hit a scene, and their depth: a whole queue of rays is intersected
; with each sphere, and the rays are made and used in vectors, too.
;
; Ray k runs along z from (x, y, 0), where x and y are the fractions of k STEP_X and k STEP_Y.
; For each sphere that it hits it computes the nearer point,
;
;   h = r^2 - (x - cx)^2 - (y - cy)^2,   z = cz - sqrt(h)   if h >= 0
;
; and the minimum z.  seen counts the rays with a hit, depth is the sum of their z.
;
; With q = x^2 + y^2, once for all spheres, -h = q - 2 cx x - 2 cy y - (r^2 - cx^2 - cy^2) is two
; linked pairs and a comparison.  Few digits cancel: all numbers are below 3.

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
iota:   .space  queue
xs:     .space  queue
ys:     .space  queue
nearest:
        .space  queue
qs:     .space  queue                   ; x^2 + y^2
us:     .space  queue
ss:     .space  queue
places: .space  queue                   ; of the rays that hit the sphere:
zs:     .space  queue                   ; their z,
olds:   .space  queue                   ; and the previous nearest z
        .bitvector meets, queue
        .code

        .regs   r10, left, length, body, body_at, next_body, place, record, apart
        .regs   r20, cx, cy, cz, radius2, xx, yy, least
        .regs   r30, order, x, y, near, q, u, s, handed, at, z, old, bits, nearer
        .regs   r50, step_x, step_y, first_x, first_y, one, big, stride_x, stride_y
        .regs   r60, upper, lower, sum, count, total

        load_constant step_x, STEP_X
        load_constant step_y, STEP_Y
        load_constant stride_x, queue * STEP_X
        load_constant stride_y, queue * STEP_Y
        load_constant first_x, 0.0
        load_constant first_y, 0.0
        load_constant big, 1e30
        load_constant sum, 0.0
        ES      total, 0
        ES      one, 1
        EX      left, rays
        EX      record, 4 * 64
        EX      apart, 64 * queue
        EX      next_body, a_body
        descriptor order, iota, queue
        INTVLV  r0, one, [order]
        EX      length, queue

        .macro  vector name, address
        EX      \name, \address
        ADDLEN  \name, length, \name
        .endm

a_queue:
        .kernel make
        IBXGE   left, r0, length, full
        RTOR    left, length            ; the last queue
full:   vector  order, iota
        vector  x, xs
        vector  y, ys
        vector  u, us
        vector  s, ss
        vector  q, qs
        vector  handed, us              ; not stored
        vector  near, nearest
        vector  bits, meets
        INTVLV  first_x, step_x, [x]
        FLRV    [x], [u]
        SUBNV   [x], [u], [x]
        INTVLV  first_y, step_y, [y]
        FLRV    [y], [u]
        SUBNV   [y], [u], [y]
        ADDN    first_x, stride_x, first_x
        ADDN    first_y, stride_y, first_y
        MPYSV   [x], [x], [q]
        MPYSV   [y], [y], [u]
        ADDNV   [q], [u], [q]
        VTOV    big, [near]
        .endkernel

        .kernel intersect
        EX      body_at, spheres
        ELEN    body_at, 4
        ES      body, bodies
a_body: SWAP    [body_at], cx, [r0]
        ADDX    body_at, record, body_at
        EX      at, places
        MPYS    cx, cx, xx
        MPYS    cy, cy, yy
        SUBN    radius2, xx, least
        SUBN    least, yy, least
        ADDN    cx, cx, cx
        ADDN    cy, cy, cy
        LINKV
        MPYSV   [x], cx, [handed]
        SUBNV   [q], [handed], [s]
        LINKV
        MPYSV   [y], cy, [handed]
        SUBNV   [s], [handed], [s]
        CMPGEV  least, [s], [bits]
        CPSV    [order], [at] ? [bits]
        ADDX    at, apart, z
        ADDX    z, apart, old
        LTOR    at, count
        EX      nearer, meets           ; with the same length
        ADDLEN  nearer, count, nearer
        VXTOV   [at], [s], [z]
        VXTOV   [at], [near], [old]
        SUBNV   least, [z], [z]
        SQRTV   [z], [z]
        SUBNV   cz, [z], [z]
        CMPLTV  [old], [z], [nearer]
        VTOV    [old], [z] ? [nearer]
        VTOVX   [at], [z], [near]
        DBNZ    body, [next_body]
        .endkernel

        .kernel use
        CMPLTV  [near], big, [bits]
        SUMV    [near], upper ? [bits]
        CNTOB   [bits], count
        join_parts upper, lower, upper
        ADDN    sum, upper, sum
        ADDX    total, count, total
        SUBX    left, length, left
        IBXNE   left, r0, r0, again
        ADDN    total, r0, total
        EX      place, seen
        STO     [place], total
        EX      place, depth
        STO     [place], sum
        EXIT
again:  BIM     a_queue
        .endkernel
