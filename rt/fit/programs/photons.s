; photons.s - photons in a slab by the Monte Carlo method, one after the other
; and all at a time.
;
; Photons enter at x = 0 along the axis of a slab.  Each flies a distance -ln u1,
; is reflected or transmitted if it leaves the slab there, is absorbed with the
; probability 1 - SURVIVAL, or else flies on in a direction whose cosine is
; 2 u3 - 1.  Every photon draws its numbers from a row of its own, so that both
; forms do the same operations on the same numbers and their tallies agree.
;
; The vector form moves all photons that are left by one flight at a time and
; then compresses what it keeps of them.  The scalar form has all in registers
; and calls nothing.
;
; Source of the method: F. B. Brown and W. R. Martin, Monte Carlo methods for
; radiation transport analysis on vector computers, Prog. Nucl. Energy 14 (1984).

        .include "photons.inc"

        .equ    PHOTONS, 4000
        .equ    APART, 1024     ; draws from the row of one to that of the next

        .data
seeds:          .space PHOTONS
left_x:         .space PHOTONS
left_mu:        .space PHOTONS
left_seeds:   .space PHOTONS
work_u:         .space PHOTONS
work_e:         .space PHOTONS
work_y:         .space PHOTONS
work_square:    .space PHOTONS
work_p:         .space PHOTONS
work_q:         .space PHOTONS
        .bitvector out, PHOTONS
        .bitvector through, PHOTONS
        .bitvector on, PHOTONS
        .code

        .regs   r10, minus, at, count, seed, jump
        .regs   r20, reflected, transmitted, absorbed
        .regs   r24, reflected_v, transmitted_v, absorbed_v, failed
        .regs   r30, u, e, y, square, p, q, x, mu
        .regs   r40, n, n_in
        .regs   r44, s_at, x_at, mu_at, u_at, e_at, y_at, square_at, p_at, q_at
        .regs   r53, out_at, through_at, on_at
        .regs   r60, s_v, x_v, mu_v, u_v, e_v, y_v, square_v, p_v, q_v
        .regs   r69, out_z, through_z, on_z

        .entry  photons
photons:
        EX      at, photon_constants
        ELEN    at, PHOTON_CONSTANTS
        SWAP    [at], multiplier, [r0]
        ES      minus, -1

; jump := MULTIPLIER to the power APART; the seeds are its powers.
        ES      jump, 1
        ES      count, APART
power:  MPYL    jump, multiplier, jump
        IBXNE   count, minus, r0, power, count
        EX      at, seeds
        ES      count, PHOTONS
        ES      seed, 1
sow:    MPYL    seed, jump, seed
        STO     [at], seed
        IX      at, 64
        IBXNE   count, minus, r0, sow, count

; ---- One after the other ----------------------------------------------------

        .macro  draw result
        MPYL    seed, multiplier, seed
        ADDN    seed, r0, \result
        MPYS    \result, to_unit, \result
        .endm

        .kernel scalar
        EX      at, seeds
        ES      count, PHOTONS
        ES      reflected, 0
        ES      transmitted, 0
        ES      absorbed, 0
next:   LOD     [at], seed
        RTOR    r0, x
        RTOR    unit, mu
flight: draw    u
        EXP     u, e
        PACK    scale, u, y
        ADDN    e, offset, e
        SUBN    y, three, y
        MPYS    e, minus_ln2, e
        MPYS    y, y, square
        MPYS    p5, y, p
        MPYS    p3, y, q
        MPYS    p1, y, y
        ADDN    p, p4, p
        ADDN    q, p2, q
        MPYS    p, square, p
        ADDN    y, p0, y
        ADDN    p, q, p
        MPYS    p, square, p
        ADDN    p, y, p
        SUBN    e, p, e                 ; -ln u
        MPYS    e, mu, e
        ADDN    x, e, x
        CFPLT   x, r0, goes_back
        CFPGE   x, depth, goes_through
        draw    u
        CFPGE   u, survival, is_absorbed
        draw    u
        MPYS    u, two, u
        SUBN    u, unit, mu
        BIM     flight
goes_back:
        IS      reflected, 1
        BIM     ended
goes_through:
        IS      transmitted, 1
        BIM     ended
is_absorbed:
        IS      absorbed, 1
ended:  IX      at, 64
        IBXNE   count, minus, r0, next, count
        .endkernel

; ---- All at a time ----------------------------------------------------------

        .macro  draw_all result
        MPYLV   [s_v], multiplier, [s_v]
        ADDNV   [s_v], r0, [\result]
        MPYSV   [\result], to_unit, [\result]
        .endm

; b := a y + c
        .macro  line a, c, b
        LINKV
        MPYSV   [y_v], \a, [\b]
        ADDNV   [\b], \c, [\b]
        .endm

; Vectors of as many elements as photons fly.
        .kernel vector
        EX      s_at, left_seeds
        EX      x_at, left_x
        EX      mu_at, left_mu
        EX      u_at, work_u
        EX      e_at, work_e
        EX      y_at, work_y
        EX      square_at, work_square
        EX      p_at, work_p
        EX      q_at, work_q
        EX      out_at, out
        EX      through_at, through
        EX      on_at, on
        ES      n, PHOTONS
        ADDLEN  s_at, n, s_v
        EX      at, seeds
        ELEN    at, PHOTONS
        VTOV    [at], [s_v]
        ADDLEN  x_at, n, x_v
        VTOV    r0, [x_v]
        ADDLEN  mu_at, n, mu_v
        VTOV    unit, [mu_v]
        ES      reflected_v, 0
        ES      transmitted_v, 0
        ES      absorbed_v, 0
fly:    ADDLEN  u_at, n, u_v
        draw_all u_v
        ADDLEN  e_at, n, e_v
        EXPV    [u_v], [e_v]
        ADDLEN  y_at, n, y_v
        PACKV   scale, [u_v], [y_v]
        LINKV
        ADDNV   [e_v], offset, [e_v]
        MPYSV   [e_v], minus_ln2, [e_v]
        SUBNV   [y_v], three, [y_v]
        ADDLEN  square_at, n, square_v
        MPYSV   [y_v], [y_v], [square_v]
        ADDLEN  p_at, n, p_v
        line    p5, p4, p_v
        ADDLEN  q_at, n, q_v
        line    p3, p2, q_v
        line    p1, p0, y_v
        MPYSV   [p_v], [square_v], [p_v]
        ADDNV   [p_v], [q_v], [p_v]
        MPYSV   [p_v], [square_v], [p_v]
        ADDNV   [p_v], [y_v], [p_v]
        SUBNV   [e_v], [p_v], [e_v]
        MPYSV   [e_v], [mu_v], [e_v]
        ADDNV   [x_v], [e_v], [x_v]

        ADDLEN  out_at, n, out_z
        CMPLTV  [x_v], r0, [out_z]
        ADDLEN  through_at, n, through_z
        CMPGEV  [x_v], depth, [through_z]
        CNTOB   [out_z], count
        ADDX    reflected_v, count, reflected_v
        SUBX    n, count, n
        CNTOB   [through_z], count
        ADDX    transmitted_v, count, transmitted_v
        SUBX    n, count, n
        ORB     [out_z], [through_z], [out_z]
        CPSV    [s_v], [s_v] ?! [out_z]
        CPSV    [x_v], [x_v] ?! [out_z]
        ADDLEN  u_at, n, u_v
        draw_all u_v
        ADDLEN  on_at, n, on_z
        CMPLTV  [u_v], survival, [on_z]
        RTOR    n, n_in
        CNTOB   [on_z], n
        SUBX    n_in, n, n_in
        ADDX    absorbed_v, n_in, absorbed_v
        CPSV    [s_v], [s_v] ? [on_z]
        CPSV    [x_v], [x_v] ? [on_z]
        ADDLEN  mu_at, n, mu_v
        draw_all mu_v
        LINKV
        MPYSV   [mu_v], two, [mu_v]
        SUBNV   [mu_v], unit, [mu_v]
        IBXNE   n, r0, r0, fly
        .endkernel

        ES      failed, 0
        IBXNE   reflected, r0, reflected_v, differs
        IBXNE   transmitted, r0, transmitted_v, differs
        IBXEQ   absorbed, r0, absorbed_v, equals
differs:
        ES      failed, 1
equals: EXIT    failed
; expect: failed = 0
