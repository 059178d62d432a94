        .include "vectors.s"
        .regs   r16, first, step, c
        load_constant first, 1.5
        load_constant step, 0.5
        words   c
        INTVLV  first, step, [c]
        EXIT
; expect: [c.words] = 1.5, 2.0, 2.5, 3.0
