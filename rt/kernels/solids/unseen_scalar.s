; unseen_scalar.s - the crossings that can be seen of a primitive that cuts others
; and is not seen itself: none.
;
;       CALL UNSEEN (RAY, PRIMITIVE, CROSSINGS)
;
; CROSSINGS, as many words as its descriptor is long: each a miss, big.  What is
; inside of it P_STATE_KERNEL tells.
; Source: derived here, for clipped_by.

        .kernel visible
unseen:
        IX      arguments, 64 * 2
        LOD     [arguments], third
        LTOR    third, fourth
unseen_next:
        STO     [third], m_big
        IX      third, 64
        IBXNE   fourth, m_index_minus_one, r0, unseen_next, fourth
        BIM     0, link
        .endkernel
