; start.s - the rays that hit a scene, and their depth: ray by ray, in scalar code.
;
; Correct, and slow.  Ray k runs along z from (x, y, 0), where x and y are the fractions of
; k STEP_X and k STEP_Y.  For each sphere that it hits it computes the nearer point,
;
;   h = r^2 - (x - cx)^2 - (y - cy)^2,   z = cz - sqrt(h)   if h >= 0
;
; and the minimum z.  seen counts the rays with a hit, depth is the sum of their z.

        .include "core.s"

        .ifndef rays
        .equ    rays, 1000
        .equ    queue, 100              ; rays in the queue, not yet used
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
        .code

        .regs   r10, ray, count, body, body_at, next_ray, next_body, place, record
        .regs   r20, cx, cy, cz, radius2
        .regs   r30, x, y, nearest, u, v, h, z
        .regs   r40, step_x, step_y, one, big, total, sum

        load_constant step_x, STEP_X
        load_constant step_y, STEP_Y
        load_constant one, 1.0
        load_constant big, 1e30
        load_constant x, 0.0
        load_constant y, 0.0
        load_constant total, 0.0
        load_constant sum, 0.0
        EX      ray, rays
        EX      next_ray, a_ray
        EX      next_body, a_body
        EX      record, 4 * 64

; your code here: replace this loop by a queue of rays; intersect the whole queue with each sphere.

        .kernel use
a_ray:  RTOR    big, nearest
        EX      body_at, spheres
        ELEN    body_at, 4
        ES      body, bodies
        .endkernel

        .kernel intersect
a_body: SWAP    [body_at], cx, [r0]
        ADDX    body_at, record, body_at
        SUBN    x, cx, u
        SUBN    y, cy, v
        MPYS    u, u, u
        MPYS    v, v, v
        SUBN    radius2, u, h
        SUBN    h, v, h
        CFPLT   h, r0, passed
        SQRT    h, h
        SUBN    cz, h, z
        CFPGE   z, nearest, passed
        RTOR    z, nearest
passed: DBNZ    body, [next_body]
        .endkernel

        .kernel use
        CFPGE   nearest, big, unseen
        ADDN    total, one, total
        ADDN    sum, nearest, sum
unseen:
        .endkernel

        .kernel make
        ADDN    x, step_x, x
        ADDN    y, step_y, y
        CFPLT   x, one, x_is_fraction
        SUBN    x, one, x
x_is_fraction:
        CFPLT   y, one, y_is_fraction
        SUBN    y, one, y
y_is_fraction:
        DBNZ    ray, [next_ray]
        .endkernel

        EX      place, seen
        STO     [place], total
        EX      place, depth
        STO     [place], sum
        EXIT
