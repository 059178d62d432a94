; invisible_scalar.s - the visible crossings of an invisible primitive: none.
;
;       CALL INVISIBLE (RAY, PRIMITIVE, CROSSINGS)
;
; Stores a miss, big, in each word of CROSSINGS. The primitive only cuts others.
; P_STATE_KERNEL computes its segments.
; Source: derived here, for clipped_by.

        .kernel visible
invisible:
        IX      arguments, 64 * 2
        LOD     [arguments], third
        LTOR    third, fourth
invisible_next:
        STO     [third], m_big
        IX      third, 64
        IBXNE   fourth, m_index_minus_one, r0, invisible_next, fourth
        BIM     0, link
        .endkernel
