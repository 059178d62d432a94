; quadratic_vector.s - a queue of quadratics  a t^2 + 2 b t + c.
;
;   disc = b^2 - a c              disc < 0: no root
;   q = -(b + sign(b) sqrt(disc)) (sign(0) = +)
;   first = q / a,  second = c / q
;
; Nothing cancels in q; of the two roots the one that would is c / q.  Two
; kinds of lanes are left to the caller, who counts them and seldom finds any:
; a = 0 (bits1) has no first root, q = 0 (bits2) no second one; there what is
; divided by 0 is indefinite.  q = 0 means b = 0 and a c = 0.
;
; In:  a, b, c.  Out: disc; then q in its place, first, second; bits0 = real.
; Source: textbook; the project's notes on ray tracing, 4.2.

        .macro  discriminant a, b, c, disc, work
        MPYSV   [\b], [\b], [\disc]
        MPYSV   [\a], [\c], [\work]
        SUBNV   [\disc], [\work], [\disc]
        .endm

        .macro  quadratic_roots a, b, c, disc, first, second
        CMPGEV  [\disc], r0, [bits0]
        SQRTV   [\disc], [\disc] ? [bits0]
        ADDNV   |[\b]|, [\disc], [\disc]
        CMPGEV  [\b], r0, [bits1]
        VTOV    -[\disc], [\disc] ? [bits1]
        DIVSV   [\disc], [\a], [\first]
        DIVSV   [\c], [\disc], [\second]
        CMPEQV  [\a], r0, [bits1]
        CMPEQV  [\disc], r0, [bits2]
        .endm

; tin = the lesser of first and second, tout = the greater.
        .macro  sort_roots first, second
        CMPLTV  [\second], [\first], [bits1]
        MASKV   [\second], [\first], [tin] ? [bits1]
        MASKV   [\first], [\second], [tout] ? [bits1]
        .endm

; From the origin x of the rays, told from the shape's centre, to o, their
; closest approach to it:  along = x . D,  o = x - along D.  Distances from
; there are along more than those from x.
        .macro  closest_approach x0, x1, x2, o0, o1, o2, along, work
        dot_vectors \x0, \x1, \x2, dx, dy, dz, \along, \work
        MPYSV   [\along], [dx], [\work]
        SUBNV   [\x0], [\work], [\o0]
        MPYSV   [\along], [dy], [\work]
        SUBNV   [\x1], [\work], [\o1]
        MPYSV   [\along], [dz], [\work]
        SUBNV   [\x2], [\work], [\o2]
        .endm

; The segments found, from the old origin again.
        .macro  move_back along
        CMPGEV  [tout], [tin], [bits0]
        SUBNV   [tin], [\along], [tin] ? [bits0]
        SUBNV   [tout], [\along], [tout] ? [bits0]
        .endm
