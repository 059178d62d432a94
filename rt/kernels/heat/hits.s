; hits.s - whether rays strike one of some solid cylinders, and no more: what the two forms
; have in common.
;
; A cylinder has the axis C + h A, 0 <= h <= L, |A| = 1, and the radius r.  Of a ray O + t D,
; |D| = 1, from O - C = W:
;
;   b = W . A     a = D . A               along the axis
;   p = W . D - a b,  q = W . W - b^2 - r^2,  g = 1 - a^2
;
; Across the axis it is inside where g t^2 + 2 p t + q <= 0: never, if p^2 - g q < 0; else
; for g t from -p - s to -p + s, s the root.  It strikes if for some g t of these, not below 0,
; its height h, g h = g b + a (g t), is between 0 and g L: as h changes evenly, unless it is
; below 0 at both ends, or above g L at both.  Nothing is divided; a ray along the axis,
; g = 0, passes.
;
; In:  what stands below.
; Out: hits_made, of each ray 1: it strikes one, 0: it strikes none.
; Source: derived here; "it is only of interest knowing that the ray strikes the tube
; and not where": Plunkett, Cychosz and Bailey 1984.

        .record CYLINDER
        .field  CYLINDER_BASE, 3
        .field  CYLINDER_AXIS, 3
        .field  CYLINDER_LENGTH
        .field  CYLINDER_SQUARE         ; r^2
        .endrecord

        .data
hits_given:
hits_rays:      .word 0                 ; how many, an integer
hits_from:      .word 0                 ; address of the planes of O: x, y, z
hits_towards:   .word 0                 ; .. of D
hits_cylinders: .word 0                 ; how many, 1 or more, an integer
hits_list:      .word 0                 ; address of their records
hits_made:      .word 0                 ; .. of a plane
                .word 1, -1
                .word 1.0
                .equ    HITS_GIVEN, 9
        .code

        .regs   r10, hit_rays, hit_from, hit_towards, hit_cylinders, hit_list, hit_made
        .regs   r16, hit_one, hit_minus_one, hit_unit
        .regs   r19, hit_stride         ; from a plane to the next, in bits
        .regs   r20, cyl_x, cyl_y, cyl_z, cyl_ax, cyl_ay, cyl_az, cyl_length, cyl_square
        .regs   r28, hit_at, hit_left, hit_work

        .macro  hits_begin
        EX      hit_work, hits_given
        ELEN    hit_work, HITS_GIVEN
        SWAP    [hit_work], hit_rays, [r0]
        SHIFTI  hit_rays, 6, hit_stride
        .endm

; The next cylinder.
        .macro  load_cylinder
        ELEN    hit_at, CYLINDER_SIZE
        SWAP    [hit_at], cyl_x, [r0]
        IX      hit_at, 64 * CYLINDER_SIZE
        .endm
