        .include "vectors.s"
        .regs   r16, a, b, c, x, y, z
        words   a, 1.0, 2.0, 3.0
        bits    x, "11010"
        words   b, 10.0, 20.0
        bits    y, "01001"
        words   c
        bits    z, "00000"
        ADDNS   [a, x], [b, y], [c], [z]
        .regs   r22, d, e, f            ; operands of 32 bits
        halves  d, 1.0, 2.0, 3.0
        halves  e, 10.0, 20.0
        halves  f
        ADDNS,H [d, x], [e, y], [f], [z]
        .regs   r25, sums, third
        bits    third, "10010"
        words   sums
        ADDNS   [a, x], [b, y], [sums] ? [third]
        EXIT
; expect: [sums.words] = 1.0, 3.0, 0
; expect: [c.words] = 1.0, 12.0, 3.0, 20.0
; expect-halves: [f.halves] = 1.0, 12.0, 3.0, 20.0
; expect-bits: [z.bits] = 11011
