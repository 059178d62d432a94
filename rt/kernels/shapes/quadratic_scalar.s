; quadratic_scalar.s - solves one quadratic  a t^2 + 2 b t + c
; (quadratic_vector.s).  Branches to no_first if a = 0, when only second exists,
; and to no_second if q = 0, for any a.  The caller handles a negative
; discriminant.

; Registers of the kernels that solve a quadratic, after t9.
        .share  local
        .regs   r58, shift, quad_a, quad_b, quad_c, o_along, d_along, k_along
        .endshare

        .macro  discriminant a, b, c, disc, work
        MPYS    \b, \b, \disc
        MPYS    \a, \c, \work
        SUBN    \disc, \work, \disc
        .endm

        .macro  quadratic_roots a, b, c, disc, first, second, no_first, no_second
        SQRT    \disc, \disc
        ABS     \b, \first
        ADDN    \first, \disc, \disc
        CFPLT   \b, r0, quadratic_signed\@
        SUBN    r0, \disc, \disc
quadratic_signed\@:
        CFPEQ   \disc, r0, \no_second
        DIVS    \c, \disc, \second
        CFPEQ   \a, r0, \no_first
        DIVS    \disc, \a, \first
        .endm

        .macro  sort_roots first, second
        RTOR    \first, tin
        RTOR    \second, tout
        CFPGE   \second, \first, sorted\@
        RTOR    \second, tin
        RTOR    \first, tout
sorted\@:
        .endm

        .macro  closest_approach x0, x1, x2, o0, o1, o2, along, work0, work1
        dot     \x0, \x1, \x2, dx, dy, dz, \along, \work0
        MPYS    \along, dx, \work0
        MPYS    \along, dy, \work1
        MPYS    \along, dz, third
        SUBN    \x0, \work0, \o0
        SUBN    \x1, \work1, \o1
        SUBN    \x2, third, \o2
        .endm

        .macro  move_back along
        SUBN    tin, \along, tin
        SUBN    tout, \along, tout
        .endm
