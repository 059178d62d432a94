; quadratic_vector.s - solves a queue of quadratics  a t^2 + 2 b t + c.
;
;   disc = b^2 - a c              disc < 0: no root
;   q = -(b + sign(b) sqrt(disc)) (sign(0) = +)
;   first = q / a,  second = c / q
;
; Nothing cancels in q.  The root that would cancel is c / q.  The caller
; handles two rare kinds of lanes and counts them: a = 0 (bits1) has no first
; root, q = 0 (bits2) has no second one.  There the quotient is indefinite.  q =
; 0 means b = 0 and a c = 0.
;
; In:  a, b, c.  Out: disc; then q in its place, first, second; bits0 = the root
;      is real.
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

; tin = the smaller of first and second, tout = the greater.
        .macro  sort_roots first, second
        CMPLTV  [\second], [\first], [bits1]
        MASKV   [\second], [\first], [tin] ? [bits1]
        MASKV   [\first], [\second], [tout] ? [bits1]
        .endm

; Moves the rays' origins x, relative to the shape's centre, to o, their closest
; approach to it:  along = x . D,  o = x - along D.  A distance from o is
; greater by along than that from x.
        .macro  closest_approach x0, x1, x2, o0, o1, o2, along, work
        dot_vectors \x0, \x1, \x2, dx, dy, dz, \along, \work
        MPYSV   [\along], [dx], [\work]
        SUBNV   [\x0], [\work], [\o0]
        MPYSV   [\along], [dy], [\work]
        SUBNV   [\x1], [\work], [\o1]
        MPYSV   [\along], [dz], [\work]
        SUBNV   [\x2], [\work], [\o2]
        .endm

; Measures the segments from the original origin again.
        .macro  move_back along
        CMPGEV  [tout], [tin], [bits0]
        SUBNV   [tin], [\along], [tin] ? [bits0]
        SUBNV   [tout], [\along], [tout] ? [bits0]
        .endm
