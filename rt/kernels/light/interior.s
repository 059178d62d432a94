; interior.s - the bodies that contain a ray.  The file is included if INTERIORS
; is 1: light passes through something.
;
; Bodies have the numbers 1, 2, .. below a base B, a power of 2.  The bodies
; that contain a ray are one number S = T B + b, where b is the last one entered
; and T the bodies before it.  S = 0: none; S = -1: unknown, as for camera rays.
; A ray with unknown S has S = 0 if it enters a body, and that body if it leaves
; one, for it started inside.
;
; At a surface of body b, n(x) is the index of refraction of x, n(0) = 1, and
; n(S) is that of the last body of S:
;
;   b is the last of S      the ray leaves it: S' = T,          e = n(b) / n(T)
;   b is in T               S' = S without it,                  e = 1
;   b is not in S           the ray enters it: S' = S B + b,    e = n(S) / n(b)
;
; For a mirror by Fresnel's formulas (gloss.s), w is the ratio of the index
; behind the surface to that in front: n(b) / n(S) if the ray enters b,
; n(0) / n(b) if it leaves b for air, else n(S) / n(b).
;
; e within 1e-10 of 1 counts as 1 (k_checker, which has this value, is the
; tolerance).  With e = 1 a ray continues straight and keeps its parent's level,
; which limits the number of successive rays; otherwise its level is the next
; one.  A reflected ray is in S.
;
; S' has room for 46 bits.  If the number of bodies could need more,
; the first body that the ray entered is dropped: F = B^k is the greatest number
; to which a body can still be added, and S - F floor(S / F) replaces S.  All
; these numbers are integers, and exact.
; Source: the rules are POV-Ray's, whose rays remember 100 bodies.

        .record INTERIORS_OF
        .field  INTERIORS_TABLE         ; address of n(0), n(1), ..
        .field  INTERIORS_BASE, 2       ; B, 1 / B
        .field  INTERIORS_FULL, 2       ; F, or 0: there is always room; 1 / F
        .field  INTERIORS_LEVELS        ; max_trace_level, a number
        .endrecord

        .data
scene_interiors: .space INTERIORS_OF_SIZE
        .code

; under = T, last = the last of the bodies in all.
        .macro  last_of all, under, last
        scale   \all, in_per_base, \under
        floor   \under, \under
        normal  \under, \under
        scale   \under, in_base, \last
        minus   \all, \last, \last
        .endm

; index = n(body); body becomes the index into the table.
        .macro  index_of body, index
        floor   \body, \body
        gather  \body, in_table, \index
        .endm

; room = all without its first body.
        .macro  drop_first all, room
        scale   \all, in_per_full, \room
        floor   \room, \room
        normal  \room, \room
        minus_scaled \all, \room, in_full, \room
        .endm
