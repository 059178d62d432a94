; spawn_scalar.s - computes the rays spawned by a hit.
;
;       CALL SPAWN (RAY, PRIMITIVE, SURFACE, WEIGHT, FOLLOWED, REFLECTED,
;                   REFRACTED)
;
; In:
;   RAY        O, D (6 words)
;   PRIMITIVE  the record of the primitive that the ray hits
;   SURFACE    fields of the sample: the normal N turned against the ray, N . D,
;              outward N . D, offset of the colour, point (9 words); with BUMPS
;              also the normal without bumps (3 words)
;   WEIGHT     the weight of the ray (1 word); with INTERIORS it is preceded by
;              the bodies that contain the ray, and by its level (3 words)
;   PIGMENT    the colour at the hit (3 words); only with GLOSS, the last argument
; Out:
;   FOLLOWED   two integers: 1 if there is a reflected ray, 1 if there is a
;              refracted ray, else 0; with HIDDEN, 2 is total reflection
;   REFLECTED, REFRACTED
;              O, D, the lower limit, the lower limit to be scaled, with
;              INTERIORS the region that the ray passed, bodies and level, the
;              weight, the factor of its colour (12 words without INTERIORS)
;
; The formulas and the order of the operations are those of spawn_vector.s.  If
; the outward N . D is below 0, the ray enters the shape, or leaves it if the
; shape is inverted.

        .share  local
        .regs   r32, sp_ray, primitive, sp_surface, sp_weight_at
        .regs   r36, sp_followed, sp_reflected_at, sp_refracted_at
        .regs   r39, sp_dx, sp_dy, sp_dz
        .regs   r42, sp_nx, sp_ny, sp_nz, sp_facing, sp_outward, sp_cell
        .regs   r48, sp_ox, sp_oy, sp_oz        ; the new ray
        .regs   r51, sp_x, sp_y, sp_z, sp_lower, sp_scaled
        .if     INTERIORS
        .regs   r56, sp_passed, sp_inside, sp_level
        .regs   r59, sp_weight, sp_red, sp_green, sp_blue, sp_greatest
        .regs   r64, sp_inverted, sp_mirror, sp_clear, sp_index
        .regs   r68, sp_reciprocal
        .regs   r69, sp_own_inside, sp_own_level, sp_own_weight
        .regs   r72, sp_least, sp_e, sp_k, sp_t0, sp_t1, sp_t2
        .regs   r78, sp_flag, sp_at
        .else
        .regs   r56, sp_weight, sp_red, sp_green, sp_blue, sp_greatest
        .regs   r61, sp_inverted, sp_mirror, sp_clear, sp_index
        .regs   r65, sp_reciprocal
        .regs   r66, sp_own_weight, sp_least, sp_e, sp_k, sp_t0, sp_t1, sp_t2
        .regs   r73, sp_flag, sp_at
        .endif
        .endshare
        .if     GLOSS
        .reg    g_seen, sp_t0
        .include "light/mirror.s"
        .if     BUMPS == 0
        .equ    SPAWN_REGISTERS, MIRROR_REGISTERS
        .endif
        .equ    SPAWN_ARGUMENTS, 8
        .else
        .if     BUMPS == 0
        .if     INTERIORS
        .equ    SPAWN_REGISTERS, 60
        .else
        .equ    SPAWN_REGISTERS, 43
        .endif
        .endif
        .equ    SPAWN_ARGUMENTS, 7
        .endif
        .if     BUMPS
        .share  local
        .regs   r126, sp_before_x, sp_before_y, sp_before_z, sp_bump
        .endshare
        .equ    SPAWN_REGISTERS, 98     ; up to these
        .endif

; A new ray, in the order of the registers from sp_ox on.
        .record CHILD
        .field  CHILD_RAY, 6            ; O, D
        .field  CHILD_MIN, 2          ; lower limit; the same, to be scaled
        .if     INTERIORS
        .field  CHILD_PASSED            ; rank of the region whose
                                ; transparent surface it passed, or 0
        .field  CHILD_INSIDE            ; the bodies that contain it
        .field  CHILD_LEVEL             ; its level
        .endif
        .field  CHILD_WEIGHT
        .field  CHILD_FACTOR, 3         ; of its colour in its parent's
        .endrecord

        .if     INTERIORS
        .include "light/interior.s"
        .include "light/interior_scalar.s"
        .equ    SPAWN_STATE, 3          ; INSIDE, LEVEL, WEIGHT
        .else
        .equ    SPAWN_STATE, 1
        .endif

        .data
spawn_save:     .space SPAWN_REGISTERS
        .code

        .if     BUMPS
; Corrects a direction sp_x .. that would go behind the surface (bump.s).
        .macro  mirror_outside
        IBXEQ   sp_bump, r0, r0, mirror_is_outside\@
        dot     sp_x, sp_y, sp_z, sp_before_x, sp_before_y, sp_before_z, sp_k, sp_t0
        CFPGE   sp_k, r0, mirror_is_outside\@
        dot     sp_x, sp_y, sp_z, sp_nx, sp_ny, sp_nz, sp_t1, sp_t0
        CFPGE   sp_t1, r0, mirror_again\@
        copy_three sp_dx, sp_dy, sp_dz, sp_x, sp_y, sp_z
        dot     sp_x, sp_y, sp_z, sp_before_x, sp_before_y, sp_before_z, sp_k, sp_t0
mirror_again\@:
        MPYS    sp_k, m_two, sp_k
        three_by MPYS, sp_k, sp_before_x, sp_before_y, sp_before_z, sp_t0, sp_t1, sp_t2
        three   SUBN, sp_x, sp_y, sp_z, sp_t0, sp_t1, sp_t2, sp_x, sp_y, sp_z
mirror_is_outside\@:
        .endm
        .endif

        .macro  mirrored
        MPYS    sp_facing, m_two, sp_k
        three_by MPYS, sp_k, sp_nx, sp_ny, sp_nz, sp_t0, sp_t1, sp_t2
        three   SUBN, sp_dx, sp_dy, sp_dz, sp_t0, sp_t1, sp_t2, sp_x, sp_y, sp_z
        .if     BUMPS
        mirror_outside
        .endif
        renormalise_by m_one, m_half, sp_x, sp_y, sp_z, sp_t0, sp_t1
        .endm

; Loads the colour and its maximum component, at an offset of the record plus
; position, and computes the weight.
        .macro  weigh offset, position
        ADDX    primitive, \position, sp_at
        IX      sp_at, 64 * (\offset)
        load_from sp_at, 4, sp_red
        MPYS    sp_own_weight, sp_greatest, sp_weight
        .endm

        .kernel spawn
spawn:
        store_words r32, SPAWN_REGISTERS, spawn_save
        load_from arguments, SPAWN_ARGUMENTS, sp_ray
        .if     GLOSS
        RTOR    sp_dx, g_pigment
        .endif
        IX      sp_ray, 64 * 3
        load_from sp_ray, 3, sp_dx
        load_from sp_surface, 9, sp_nx
        .if     BUMPS
        IX      sp_surface, 64 * (SAMPLE_BEFORE - SAMPLE_NORMAL)
        load_from sp_surface, 3, sp_before_x
        load_field P_BUMP, sp_bump
        .endif
        load_record P_INVERTED, 5, sp_inverted
        .if     INTERIORS
        load_from sp_weight_at, SPAWN_STATE, sp_own_inside
        .else
        LOD     [sp_weight_at], sp_own_weight
        .endif
        load_word scene_bailout, sp_least
        load_word k_lower, sp_scaled
        RTOR    m_tmin, sp_lower
        STO     [sp_followed], r0
        STO     [sp_followed, m_index_one], r0

        .if     INTERIORS
        ES      sp_passed, 0
        load_words scene_interiors, INTERIORS_OF_SIZE, in_table
        CFPGE   sp_own_level, in_levels, spawn_done
        load_field P_INTERIOR, in_body
        IBXNE   sp_clear, r0, r0, spawn_interiors
        .if     GLOSS
        load_field P_REFLECTION_KIND, sp_flag
        ES      sp_at, 2                        ; Fresnel's formulas
        IBXEQ   sp_flag, r0, sp_at, spawn_interiors
        .endif
        BIM     spawn_no_interiors
spawn_interiors:
        find_interiors
spawn_no_interiors:
        ADDN    sp_own_level, m_one, sp_level
        IBXEQ   sp_clear, r0, r0, spawn_reflected
        weigh   P_TRANSMITTED, sp_cell
        CFPLT   sp_greatest, r0, spawn_reflected
        CFPGE   sp_weight, sp_least, spawn_through
        ES      sp_clear, 0
spawn_through:
        copy_three sp_dx, sp_dy, sp_dz, sp_x, sp_y, sp_z
        CFPEQ   sp_e, m_one, spawn_straight
        SUBN    r0, sp_facing, sp_t0            ; c
        MPYS    sp_e, sp_e, sp_k
        MPYS    sp_t0, sp_t0, sp_t1
        SUBN    m_one, sp_t1, sp_t1
        MPYS    sp_k, sp_t1, sp_k
        SUBN    m_one, sp_k, sp_k
        CFPLT   sp_k, r0, spawn_total
        MPYS    sp_e, sp_t0, sp_t0
        SQRT    sp_k, sp_k
        .if     BUMPS
        CFPGE   r0, sp_facing, spawn_from_front
        SUBN    r0, sp_k, sp_k
spawn_from_front:
        .endif
        three_by MPYS, sp_e, sp_dx, sp_dy, sp_dz, sp_x, sp_y, sp_z
        SUBN    sp_t0, sp_k, sp_k
        three_by MPYS, sp_k, sp_nx, sp_ny, sp_nz, sp_t0, sp_t1, sp_t2
        three   ADDN, sp_x, sp_y, sp_z, sp_t0, sp_t1, sp_t2, sp_x, sp_y, sp_z
        BIM     spawn_refracted
spawn_straight:
        RTOR    sp_own_level, sp_level
spawn_refracted:
        IBXEQ   sp_clear, r0, r0, spawn_reflected
        load_field P_RANK, sp_passed
        store_to sp_ox, CHILD_SIZE, sp_refracted_at
        STO     [sp_followed, m_index_one], m_index_one
        ES      sp_passed, 0
        .endif

spawn_reflected:
        IBXEQ   sp_mirror, r0, r0, spawn_done
        weigh   P_REFLECTION, r0
        .if     GLOSS
        mirror_by_angle
mirror_constant:
        .endif
        CFPLT   sp_weight, sp_least, spawn_done
        .if     INTERIORS
        RTOR    sp_own_inside, sp_inside
        ADDN    sp_own_level, m_one, sp_level
        .endif
        mirrored
        store_to sp_ox, CHILD_SIZE, sp_reflected_at
        STO     [sp_followed], m_index_one
spawn_done:
        leave   spawn_save, SPAWN_REGISTERS

        .if     INTERIORS
spawn_total:
        IBXEQ   sp_clear, r0, r0, spawn_done
        mirrored
        RTOR    m_one, sp_red
        RTOR    m_one, sp_green
        RTOR    m_one, sp_blue
        RTOR    sp_own_inside, sp_inside
        store_to sp_ox, CHILD_SIZE, sp_refracted_at
        .if     HIDDEN
        ES      sp_flag, 2
        STO     [sp_followed, m_index_one], sp_flag
        .else
        STO     [sp_followed, m_index_one], m_index_one
        .endif
        leave   spawn_save, SPAWN_REGISTERS
        .endif
        .endkernel
