; slab_vector.s - cuts the segments of a queue of rays to the part between two
; parallel planes.
;
; Along one axis, with origin o, direction d and planes at low and high, near
; and far are the smaller and the greater of (low - o)/d, (high - o)/d.  The
; segment tin .. tout is cut to near .. far.
;
; The machine has no infinities.  A ray with |d| < tiny is parallel, and inside
; everywhere (minus_big, big) or nowhere (big, minus_big).
;
; Changes w0-w4, bits0-bits2, s0.

        .macro  slab o, d, low, high
        CMPLTV  |[\d]|, tiny, [bits0]
        MASKV   one, [\d], [w0] ? [bits0]
        DIVSV   one, [w0], [w0]
        LINKV
        SUBNV   \low, [\o], [w1]
        MPYSV   [w1], [w0], [w1]
        LINKV
        SUBNV   \high, [\o], [w2]
        MPYSV   [w2], [w0], [w2]
        CMPLTV  [w2], [w1], [bits1]
        MASKV   [w2], [w1], [w3] ? [bits1]
        MASKV   [w1], [w2], [w4] ? [bits1]
        CNTOB   [bits0], s0
        IBXEQ   s0, r0, r0, slab_crossed\@
        VTOV    minus_big, [w3] ? [bits0]
        VTOV    big, [w4] ? [bits0]
        CMPLTV  [\o], \low, [bits1]
        CMPLTV  \high, [\o], [bits2]
        ORB     [bits1], [bits2], [bits1]
        ANDB    [bits1], [bits0], [bits1]
        VTOV    big, [w3] ? [bits1]
        VTOV    minus_big, [w4] ? [bits1]
slab_crossed\@:
        CMPLTV  [tin], [w3], [bits1]
        VTOV    [w3], [tin] ? [bits1]
        CMPLTV  [w4], [tout], [bits1]
        VTOV    [w4], [tout] ? [bits1]
        .endm

; Changes an empty segment to a miss.
        .macro  close_segment
        CMPLTV  [tout], [tin], [bits0]
        VTOV    big, [tin] ? [bits0]
        VTOV    minus_big, [tout] ? [bits0]
        .endm
