        .include "vectors.s"
        .regs   r16, first, step, c
        load_constant first, 1.5
        load_constant step, 0.5
        words   c
        INTVLV  first, step, [c]
        .reg    d, r19                  ; operands of 32 bits
        load_half h60, 1.5, r9
        load_half h61, 0.5, r9
        halves  d
        INTVLV,H h60, h61, [d]
        EXIT
; expect: [c.words] = 1.5, 2.0, 2.5, 3.0
; expect-halves: [d.halves] = 1.5, 2.0, 2.5, 3.0
