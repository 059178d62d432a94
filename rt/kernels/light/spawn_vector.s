; spawn_vector.s - computes the rays spawned by the hits of a queue, reflected
; and refracted ones, for the next level.
;
; At a point X with unit normal N turned against the ray D, facing = N.D:
;
;   reflected   D' = D - (2 facing) N       times the reflection's colour
;               normalised again: within a mirroring sphere the error of the
;               length would grow with each reflection
;   refracted   e = index in front / index behind (interior.s); cosine = -facing
;               k = 1 - (e e) (1 - cosine cosine)
;               D' = e D + (e cosine - sqrt(k)) N;  e = 1: D' = D
;                                           times the transmitted colour
;
; A ray enters where the outward normal points against it; an inverted primitive
; where it does not.  k < 0 is total reflection: the refracted ray gets the
; direction of the reflected one, its colour does not change, and there is no
; other reflected ray.  A ray is followed if its importance, its parent's times
; the maximum component of the colour, is not below scene_bailout, and, if light
; passes through something, its parent's level is below the last.  A transmitted
; colour marked as too dim (maximum below 0) counts as none.
;
; In:  a part of the hits; hits0 = the hits whose normal was turned, with bumps
;      those that the ray does not enter; next_level.
; Out: rays at the end of the next level's list: reflected, then refracted.
; Source: Snell's law; the rules are POV-Ray's.

        .share  scratch
        .regs   r233, spawn_inverted, spawn_mirror, spawn_clear, spawn_index
        .regs   r237, spawn_reciprocal, spawn_r, spawn_g, spawn_b, spawn_most
        .regs   r242, spawn_tail, spawn_stride, spawn_count, spawn_kind
        .regs   r246, spawn_checker, link_spawn, spawn_into, spawn_total
        .regs   r251, spawn_bent_count, spawn_inside
        .endshare

; Appends vector, in the lanes of hits1, as the next vector of the list.
        .macro  spawn_vector vector
        RTOR    spawn_tail, spawn_into
        CPSV    [\vector], [spawn_into] ? [hits1]
        ADDX    spawn_tail, spawn_stride, spawn_tail
        .endm

        .macro  spawn_number number
        ADDLEN  spawn_tail, spawn_count, spawn_into
        VTOV    \number, [spawn_into]
        ADDX    spawn_tail, spawn_stride, spawn_tail
        .endm

; [v5] = the importance of the part's rays, times share, a number or a vector.
; hits1 = the rays that are followed.
        .macro  spawn_importance share
        load_word queue_importance, s0
        VXTOV   [at], [s0], [v4]
        MPYSV   [v4], \share, [v5]
        .if     INTERIORS
        load_word scene_interiors + 64 * INTERIORS_LEVELS, s0
        load_word queue_level, s1
        VXTOV   [at], [s1], [v4]
        CMPGEV  [v4], s0, [hits1]
        VTOV    minus_big, [v5] ? [hits1]
        .endif
        load_word scene_bailout, s0
        CMPGEV  [v5], s0, [hits1]
        .endm

        .macro  reflect d, n, to
        MPYSV   [v4], [\n], [v6]
        SUBNV   [\d], [v6], [\to]
        .endm

; v1, v2, v3 = the reflected directions.  Changes v4, v6.
        .macro  reflect_all
        MPYSV   [facing], two, [v4]
        three   reflect, hdx, hdy, hdz, nx, ny, nz, v1, v2, v3
        .if     BUMPS
        call_routine mirror_outside, link_kernel
        .endif
        renormalise v1, v2, v3, v4, v6
        .endm

; hits2 = the rays that enter.
        .macro  find_entering
        .if     BUMPS
        NANDB   [hits0], [hits0], [hits2]
        .else
        CMPLTV  [facing], r0, [hits2]
        ANDNB   [hits2], [hits0], [hits2]
        .endif
        IBXEQ   spawn_inverted, r0, r0, spawn_entering\@
        NANDB   [hits2], [hits2], [hits2]
spawn_entering\@:
        .endm

        .macro  refract d, n, to
        MPYSV   [v0], [\d], [v6]
        MPYSV   [v7], [\n], [v4]
        ADDNV   [v6], [v4], [\to] ?! [hits2]
        .endm

; Appends a channel of the factor of the refracted rays: the transmitted colour,
; or 1 in total reflection.
        .macro  spawn_weight even, odd
        VTOV    \even, [v4]
        VTOV    \odd, [v4] ? [hits3]
        VTOV    one, [v4] ? [hits2]
        spawn_vector v4
        .endm

        .kernel spawn
spawn:
        IBXEQ   next_level, r0, r0, spawn_nothing
        load_record P_INVERTED, 9, spawn_inverted
        ADDX    spawn_mirror, spawn_clear, s0
        IBXEQ   s0, r0, r0, spawn_nothing
        RTOR    link_kernel, link_spawn
        ES      spawn_total, 0
        .if     INTERIORS
        call_routine take_interiors, link_inner
        EX      target, find_interiors
        IBXNE   spawn_clear, r0, r0, spawn_interiors
        .if     GLOSS
        load_field P_REFLECTION_KIND, s0
        ES      s1, 2                           ; Fresnel's formulas
        IBXNE   s0, r0, s1, spawn_no_interiors
spawn_interiors:
        BSAVE   link_inner, [target]
spawn_no_interiors:
        .else
        BIM     spawn_no_interiors
spawn_interiors:
        BSAVE   link_inner, [target]
spawn_no_interiors:
        .endif
        .endif
        .if     GLOSS
        IBXEQ   spawn_mirror, r0, r0, spawn_no_mirror
        call_routine find_mirror, link_kernel
spawn_no_mirror:
        .endif
        .if     INTERIORS
        IBXEQ   spawn_clear, r0, r0, spawn_reflected

; Transmitted colour: sh8 .. sh11, in the odd cells of a checker (hits3) sh12 ..
; sh15.
        load_record P_TRANSMITTED, 8, sh8
        XORB    [hits3], [hits3], [hits3]
        load_field P_PIGMENT, spawn_checker
        IBXEQ   spawn_checker, r0, r0, spawn_transmitted
        .if     IMAGES
        EX      target, find_cells
        .else
        EX      target, find_checker
        .endif
        BSAVE   link_inner, [target]
        BIM     spawn_bend
spawn_transmitted:
        CFPGE   sh11, r0, spawn_bend
        ES      spawn_clear, 0
        BIM     spawn_reflected

; v0 = e, v7 = k, hits2 = total reflection; spawn_bent_count = the rays with e
; other than 1.
spawn_bend:
        XORB    [hits2], [hits2], [hits2]
        CMPNEV  [lz], one, [hits0]
        if_none hits0, spawn_bent_count, spawn_reflected
        VTOV    [lz], [v0]
        MPYSV   [v0], [v0], [v7]
        LINKV
        MPYSV   [facing], [facing], [v6]
        SUBNV   one, [v6], [v6]
        LINKV
        MPYSV   [v7], [v6], [v7]
        SUBNV   one, [v7], [v7]
        CMPLTV  [v7], r0, [hits2]
        ANDB    [hits2], [hits0], [hits2]
        VTOV    r0, [v7] ?! [hits0]
        IBXEQ   spawn_checker, r0, r0, spawn_bent
        MASKV   sh15, sh11, [v6] ? [hits3]
        keep_where CMPGEV, [v6], r0, hits2, hits1 ; not too dim
spawn_bent:
        CNTOB   [hits2], spawn_total
        .endif

spawn_reflected:
        IBXEQ   spawn_mirror, r0, r0, spawn_refracted
        .if     GLOSS
        spawn_importance [ndotl]
        .else
        spawn_importance spawn_most
        .endif
        IBXEQ   spawn_total, r0, r0, spawn_followed
        ANDNB   [hits1], [hits2], [hits1]
spawn_followed:
        if_none hits1, spawn_count, spawn_refracted
        reflect_all
        add_to_counter rays_reflected, spawn_count
        call_routine spawn_ray, link_kernel
        .if     GLOSS
        spawn_vector red
        spawn_vector green
        spawn_vector blue
        .else
        spawn_number spawn_r
        spawn_number spawn_g
        spawn_number spawn_b
        .endif
        ES      spawn_kind, 0
        .if     INTERIORS
        RTOR    lx, spawn_inside
        .endif
        call_routine spawn_rest, link_kernel

spawn_refracted:
        .if     INTERIORS
        IBXEQ   spawn_clear, r0, r0, spawn_done
        MASKV   sh15, sh11, [v6] ? [hits3]
        spawn_importance [v6]
        if_none hits1, spawn_count, spawn_done
        IBXNE   spawn_bent_count, r0, r0, spawn_refract
        copy_three [hdx], [hdy], [hdz], [v1], [v2], [v3], VTOV
        BIM     spawn_through
spawn_refract:
        IBXEQ   spawn_total, r0, r0, spawn_none_total
        reflect_all
spawn_none_total:
        SQRTV   [v7], [v7] ?! [hits2]
        .if     BUMPS
        call_routine refract_from_back, link_kernel
        .endif
        MPYSV   -[facing], [v0], [v6]
        SUBNV   [v6], [v7], [v7]
        VTOV    r0, [v7] ?! [hits0]             ; e = 1: D' = D
        three   refract, hdx, hdy, hdz, nx, ny, nz, v1, v2, v3
spawn_through:
        add_to_counter rays_refracted, spawn_count
        call_routine spawn_ray, link_kernel
        ADDX    spawn_checker, spawn_total, s0
        IBXNE   s0, r0, r0, spawn_weights
        spawn_number sh8
        spawn_number sh9
        spawn_number sh10
        BIM     spawn_weighted
spawn_weights:
        spawn_weight sh8, sh12
        spawn_weight sh9, sh13
        spawn_weight sh10, sh14
spawn_weighted:
        ES      spawn_kind, 1
        VTOV    [lx], [ly] ? [hits2]
        RTOR    ly, spawn_inside
        call_routine spawn_rest, link_kernel
        .endif
spawn_done:
        BIM     0, link_spawn
spawn_nothing:
        BIM     0, link_kernel

; Appends point and direction to the list.
spawn_ray:
        LOD     [next_level], spawn_tail
        SHIFTI  spawn_tail, 6, spawn_tail
        list_vector next_level, LIST_RAY, s0
        ADDX    s0, spawn_tail, spawn_tail
        EX      spawn_stride, 64 * LIST
        spawn_vector px
        spawn_vector py
        spawn_vector pz
        spawn_vector v1
        spawn_vector v2
        spawn_vector v3
        BIM     0, link_kernel

; Appends importance, the bodies that contain the ray, its level, the region it
; passed, class, kind, and the index of the parent in its list.  A refracted ray
; has the class of its parent.
spawn_rest:
        spawn_vector v5
        .if     INTERIORS
        spawn_vector spawn_inside
        load_word queue_level, s0
        VXTOV   [at], [s0], [v4]
        ADDNV   [v4], one, [v6]
        IBXEQ   spawn_kind, r0, r0, spawn_counted
        CMPEQV  [lz], one, [hits3]
        VTOV    [v4], [v6] ? [hits3]
spawn_counted:
        spawn_vector v6
        IBXEQ   spawn_kind, r0, r0, spawn_passed_none
        load_field P_RANK, s0
        VTOV    s0, [v6]
        load_of part_at, PART_SHARED, s0
        IBXEQ   s0, r0, r0, spawn_passed
        VXTOV   [at], [nearest_primitive], [v4]
        find_records v4, v4, P_RANK, s1
        VXTOV   [v4], [s1], [v6]
spawn_passed:
        VTOV    r0, [v6] ? [hits2]
        spawn_vector v6
        BIM     spawn_passed_listed
spawn_passed_none:
        spawn_number r0
spawn_passed_listed:
        .endif
        .if     HIDDEN
        ES      s1, REFLECTED_RAYS
        .if     INTERIORS
        IBXEQ   spawn_kind, r0, r0, spawn_class_same
        load_word queue_classes, s0
        VXTOV   [at], [s0], [v6]
        VTOV    s1, [v6] ? [hits2]
        spawn_vector v6
        BIM     spawn_class_listed
spawn_class_same:
        .endif
        spawn_number s1
spawn_class_listed:
        .endif
        spawn_number spawn_kind
        ADDLEN  spawn_tail, spawn_count, s0
        load_word queue_order, s2
        IBXNE   s2, r0, r0, spawn_by_tiles
        CPSV    [at], [s0] ? [hits1]
        ADDXV   [s0], position, [s0]
spawn_listed:
        LOD     [next_level], s0
        ADDX    s0, spawn_count, s0
        STO     [next_level], s0
        BIM     0, link_kernel
spawn_by_tiles:
        RTOR    v6, s3
        CPSV    [at], [s3] ? [hits1]
        VXTOV   [s3], [s2], [s0]
        BIM     spawn_listed
        .endkernel
