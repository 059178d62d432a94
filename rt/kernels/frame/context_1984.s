; context_1984.s - lets the vector and the scalar program share one machine.
;
; Both use the registers from r7 on, and one SWAP exchanges them. r1-r6 (links,
; lengths of the queue) are common to both. Values of the vector program's
; registers that a scalar loop needs are passed in memory.
;
; This file is included while register names are those of the vector program.

        .reg    link_queue, link        ; of the vector program
        .reg    queue_primitive, primitive
        .equ    CONTEXT, 249
        .equ    OPERANDS, 18

        .data
vector_context: .space CONTEXT
scalar_context: .space CONTEXT
operands:       .space OPERANDS
        .code

        .macro  to_scalar
        EX      s0, scalar_context
        ELEN    s0, CONTEXT
        EX      s9, vector_context
        ELEN    s9, CONTEXT
        SWAP    [s0], r7, [s9]
        .endm

        .macro  to_vector
        EX      s0, vector_context
        load_from s0, CONTEXT, r7
        .endm

; Passes `number` registers, from `register` on, as operands from `position` on.
        .macro  pass_operands register, number=1, position=0, into=operands
        EX      s0, \into + 64 * \position
        store_to \register, \number, s0
        .endm
