; pigment_scalar.s - which colour of its pigment a primitive has at a point.
;
;       CALL PIGMENT_CELL (POINT, PRIMITIVE, CELL)
;
; POINT = x, y, z (3 words); PRIMITIVE = its record; CELL = how far the colour
; stands behind the first one, in bits, if colours are four words long: 0, or
; in every other cell of a checker, where floor(x) + floor(y) + floor(z) is odd
; in the pigment's space, 256.  Order of the operations as in pigment_vector.s.

        .share  local
        .regs   r32, a_point, a_primitive, a_cell
        .regs   r40, link_saved, here
        .regs   r48, t0, t1, t2, t3, t4, t5, t6, t7, t8, t9
        .regs   r58, sh0, sh1, sh2, sh3, sh4, sh5, sh6, sh7, sh8, sh9, sh10
        .regs   r69, sh11, sh12, sh13, sh14, sh15
        .regs   r74, px, py, pz
        .regs   r77, cell
        .endshare
        .equ    PIGMENT_REGISTERS, 46

        .data
pigment_save:   .space PIGMENT_REGISTERS
        .code

        .macro  get_field offset, register
        RTOR    a_primitive, here
        IX      here, 64 * (\offset)
        LOD     [here], \register
        .endm

        .macro  get_record offset, number, first
        RTOR    a_primitive, here
        IX      here, 64 * (\offset)
        ELEN    here, \number
        SWAP    [here], \first, [r0]
        .endm

        .macro  pattern_floor k0, k1, k2, k3, sum
        dot     px, py, pz, \k0, \k1, \k2, t0, t1
        ADDN    t0, \k3, t0
        ADDN    t0, m_checker_shift, t0
        FLR     t0, \sum
        .endm

; Or to plain, if the pigment is no checker.
        .macro  checker_cell plain
        ES      cell, 0
        get_field P_CHECKER, t0
        IBXEQ   t0, r0, r0, \plain
        get_record P_PATTERN, 12, sh0
        pattern_floor sh0, sh1, sh2, sh3, t2
        pattern_floor sh4, sh5, sh6, sh7, t3
        pattern_floor sh8, sh9, sh10, sh11, t4
        ADDU    t2, t3, t2
        ADDU    t2, t4, t2
        AND     t2, m_index_one, t2
        SHIFTI  t2, 8, cell
        .endm

        .kernel shade
pigment_cell:
        EX      save_at, pigment_save
        ELEN    save_at, PIGMENT_REGISTERS
        SWAP    [r0], r32, [save_at]
        ELEN    arguments, 3
        SWAP    [arguments], a_point, [r0]
        SWAP    [a_point], px, [r0]
        checker_cell pigment_found
pigment_found:
        STO     [a_cell], cell
        leave   pigment_save, PIGMENT_REGISTERS
        .endkernel
