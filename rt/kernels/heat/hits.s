; hits.s - tests whether rays hit any of some solid cylinders.
;
; This is the common part of the two forms. A cylinder has the radius r and the
; axis C + h A with 0 <= h <= L and |A| = 1. The ray is O + t D, |D| = 1. Let
; W = O - C:
;
;   b = W . A     a = D . A               along the axis
;   p = W . D - a b,  q = W . W - b^2 - r^2,  g = 1 - a^2
;
; Across the axis the ray is inside where g t^2 + 2 p t + q <= 0. It is never
; inside if p^2 - g q < 0. Otherwise it is inside for g t from -p - s to -p + s,
; where s is the square root of p^2 - g q. It hits if, for some g t >= 0 of
; these, the height h is between 0 and L. Then g h = g b + a (g t) is between 0
; and g L. As h is linear in t, this fails only if g h is below 0 at both ends,
; or above g L at both. There is no division. A ray along the axis, g = 0, is a
; miss.
;
; In:  the words below.
; Out: hits_results, for each ray 1: it hits one, 0: it hits none.
; Source: derived here; "it is only of interest knowing that the ray strikes the
; tube and not where": Plunkett, Cychosz and Bailey 1984.

        .include "points/planes.s"

        .record CYLINDER
        .field  CYLINDER_BASE, 3
        .field  CYLINDER_AXIS, 3
        .field  CYLINDER_LENGTH
        .field  CYLINDER_SQUARE         ; r^2
        .endrecord

        .data
hits_arguments:
hits_rays:      .word 0                 ; number of rays, an integer
hits_from:      .word 0                 ; address of the planes of O: x, y, z
hits_towards:   .word 0                 ; address of the planes of D
hits_cylinders: .word 0                 ; cylinders, 1 or more, an integer
hits_list:      .word 0                 ; address of their records
hits_results:   .word 0                 ; address of a plane
                .word 1, -1
                .word 1.0
                .equ    HITS_ARGUMENTS, 9
        .code

        .regs   r10, hit_rays, hit_from, hit_towards, hit_cylinders, hit_list, hit_results
        .regs   r16, hit_one, hit_minus_one, hit_unit
        .regs   r19, hit_stride         ; bits between planes
        .regs   r20, cyl_x, cyl_y, cyl_z, cyl_ax, cyl_ay, cyl_az, cyl_length, cyl_square
        .regs   r28, hit_at, hit_left, hit_work

        .macro  hits_begin
        EX      hit_work, hits_arguments
        ELEN    hit_work, HITS_ARGUMENTS
        SWAP    [hit_work], hit_rays, [r0]
        SHIFTI  hit_rays, 6, hit_stride
        .endm

; Loads the next cylinder.
        .macro  load_cylinder
        ELEN    hit_at, CYLINDER_SIZE
        SWAP    [hit_at], cyl_x, [r0]
        IX      hit_at, 64 * CYLINDER_SIZE
        .endm

        .entry  hits
        by_hand heat/hits
