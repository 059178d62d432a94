; interior.s - the bodies that a ray is in.  Included where INTERIORS is 1: light
; passes through something.
;
; Bodies have the numbers 1, 2, .. below a base B, a power of 2.  Those that a ray
; is in are one number: with b the last that it came into and T what it was in
; before, S = T B + b; 0: it is in none; -1: it is not known yet, as of the rays of the
; eye.  Of such a ray, where it enters a body, S = 0, and where it leaves one, that
; body: it began in it.  Then at a surface of body b, n(x) the index of refraction of
; x, n(0) = 1, that of the last one of S being n(S):
;
;   b is the last of S      it is left: S' = T,            e = n(b) / n(T)
;   b is in T               S' = S without it,             e = 1
;   b is not in S           it is come into: S' = S B + b, e = n(S) / n(b)
;
; A mirror by Fresnel's formulas (gloss.s) takes for w, how much denser it is behind
; the surface, n(b) / n(S) where b is come into; n(0) / n(b) where it is left for air;
; elsewhere n(S) / n(b).
;
; e is 1, too, if it is within 1e-10 of it (k_checker, as small, serves for it).  With e = 1 a ray goes straight on, and
; is of its parent's level, by which alone it is known how many may come of one
; another; else it is of the next.  What is reflected is in S.
;
; S' has no room for more than 46 bits: if there are so many bodies that it might
; need more, that into which the ray came first is forgotten (F = B^k is the greatest
; that may still take a body: S less F times the floor of S / F is taken for S).
; All these are whole numbers, and exact.
; Source: the rules are POV-Ray's, whose rays remember 100 bodies.

        .record INTERIORS_OF
        .field  INTERIORS_TABLE         ; address of n(0), n(1), ..
        .field  INTERIORS_BASE, 2       ; B, 1 / B
        .field  INTERIORS_FULL, 2       ; F, or 0: there is room; 1 / F
        .field  INTERIORS_LEVELS        ; max_trace_level, a number
        .endrecord

        .data
scene_interiors: .space INTERIORS_OF_SIZE
        .code
