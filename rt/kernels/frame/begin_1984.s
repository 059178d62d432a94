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
