; context_1984.s - the vector program and the scalar one share a machine.
;
; Both have their registers from r7 on: one SWAP changes them.  r1-r6 (links,
; the lengths of the queue) stay as they are in both.  What a scalar loop needs
; of the vector program's registers is handed over in memory.
;
; Included where the names of registers are still the vector program's.

        .reg    link_queue, link        ; of the vector program
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
        ELEN    s0, CONTEXT
        SWAP    [s0], r7, [r0]
        .endm

; Register, and those behind it, become operands from place number on.
        .macro  hand_over register, number=1, place=0, into=operands
        EX      s0, \into + 64 * \place
        ELEN    s0, \number
        SWAP    [r0], \register, [s0]
        .endm
