        .include "vectors.s"
        .regs   r16, a, b, c, factor
        words   a, 1.0, -2.0, 3.0, 4.5
        words   b, 10.0, 0.5, -3.0, 1.5
        words   c
        load_constant factor, 2.0
        LINKV                           ; c := 2 a + b
        MPYSV   [a], factor, [c]
        ADDNV   [c], [b], [c]
        .regs   r20, d, e, f            ; operands of 32 bits
        halves  d, 1.0, -2.0, 3.0, 4.5
        halves  e, 10.0, 0.5, -3.0, 1.5
        halves  f
        load_half h60, 2.0, r9
        LINKV
        MPYSV,H [d], h60, [f]
        ADDNV,H [f], [e], [f]
        .regs   r24, bits, low          ; a shift and a logical operation
        words   bits, X'00F0', X'0F00', X'F000'
        words   low, X'000A', X'000B', X'000C'
        ES      r26, 4
        LINKV
        SHIFTV  [bits], r26, [bits]     ; not stored
        ORV     [bits], [low], [low]
        EXIT
; expect: [c.words] = 12.0, -3.5, 3.0, 10.5
; expect-halves: [f.halves] = 12.0, -3.5, 3.0, 10.5
; expect: [low.words] = X'0F0A', X'F00B', X'F000C'
