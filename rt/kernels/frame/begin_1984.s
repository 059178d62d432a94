; begin_1984.s - prepares the scalar program's registers for the loops.
;
; Each loop loads this state, which holds the constants. The registers below
; belong to the loops; those from r155 on are shared by successive loops (.share
; loop). Called by link_kernel.

        .regs   r13, loop_index, loop_count, loop_at, loop_work
        .regs   r17, loop_ray_index
        .reg    loop_link, r30

        .macro  loop_next again
        IBXLT   loop_index, m_index_one, loop_count, \again, loop_index
        .endm

; load_lane, store_lane: word `index` of vector `number` at the label `store`.
; load_lanes, store_lanes: of three vectors from `number` on.
        .macro  load_lane store, number, index, x
        EX      loop_at, \store + 64 * QUEUE * (\number)
        LOD     [loop_at, \index], \x
        .endm

        .macro  store_lane store, number, index, x
        EX      loop_at, \store + 64 * QUEUE * (\number)
        STO     [loop_at, \index], \x
        .endm

        .macro  store_lanes store, number, index, x, y, z
        store_lane \store, \number, \index, \x
        store_lane \store, \number + 1, \index, \y
        store_lane \store, \number + 2, \index, \z
        .endm

        .macro  load_lanes store, number, index, x, y, z
        load_lane \store, \number, \index, \x
        load_lane \store, \number + 1, \index, \y
        load_lane \store, \number + 2, \index, \z
        .endm

; Word `index` of three vectors, whose addresses are in a, b and c.
        .macro  load_three a, b, c, index, x, y, z
        LOD     [\a, \index], \x
        LOD     [\b, \index], \y
        LOD     [\c, \index], \z
        .endm

        .macro  store_three a, b, c, index, x, y, z
        STO     [\a, \index], \x
        STO     [\b, \index], \y
        STO     [\c, \index], \z
        .endm

        .kernel frame
begin_scalar:
        EX      s0, vector_context
        store_to r7, CONTEXT, s0
        load_main_constants
        EX      s0, scalar_context
        store_to r7, CONTEXT, s0
        to_vector
        BIM     0, link_kernel
        .endkernel
