; nearest_vector.s - which primitive each ray of the queue meets first.
;
; For each primitive its kernel gives the segment tin..tout; the hit is tin if
; that lies ahead of the ray's start (> tmin), else tout.  It counts if it is
; ahead and nearer than the best so far; the first primitive wins ties.  Of
; a patch the parameters of the hit are kept, too.
;
; In:  the queue's rays; scene_primitives, scene_primitive_count.
; Out: nearest (big: none), nearest_id (0: none); hit_s, hit_t on patches.
; Source: the paper's queue, each primitive against all rays in turn.

        .kernel nearest
find_nearest:
        VTOV    big, [nearest]
        VTOV    r0, [nearest_id]
        look_at_rays wox, woy, woz, wdx, wdy, wdz, wlower
        EX      s0, scene_primitives
        LOD     [s0], primitive
        EX      s0, scene_primitive_count
        LOD     [s0], primitives_left
        IBXEQ   primitives_left, r0, r0, nearest_done
nearest_next:
        .endkernel
        .kernel call
        load_field P_KERNEL, target
        BSAVE   link_kernel, [target]
        .endkernel
        .kernel nearest
        CMPLTV  tmin, [tin], [bits0]
        MASKV   [tin], [tout], [w0] ? [bits0]
        CMPLTV  tmin, [w0], [bits0]
        CMPLTV  [w0], [nearest], [bits1]
        ANDB    [bits0], [bits1], [bits0]
        load_record P_ID, 2, identity
        VTOV    [w0], [nearest] ? [bits0]
        VTOV    identity, [nearest_id] ? [bits0]
        IBXEQ   on_patch, r0, r0, nearest_no_patch
        VTOV    [patch_s], [hit_s] ? [bits0]
        VTOV    [patch_t], [hit_t] ? [bits0]
nearest_no_patch:
        IX      primitive, 64 * P_SIZE
        IBXNE   primitives_left, minus_one_index, r0, nearest_next, primitives_left
nearest_done:
        BIM     0, link
        .endkernel
