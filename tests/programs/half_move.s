; Half words that are gathered, scattered, masked, merged, compressed or computed in
; series are compared with results worked out by hand.  An index or period of the wrong
; size makes one differ.
; Vectors of half words: elements moved, computed from two numbers, and from a
; polynomial.

        .include "half_vector.inc"

        five    a, 1.0, 2.0, 3.0, 4.0, 5.0
        five    b, -1.0, -2.0, -3.0, -4.0, -5.0
        some_scalars 3.0, 0.5
list:   .word   3, 0, -1, 2, X'7123 0000 0000 0004'
        odd
        .half   X'0ABC DEF1'
table:  .halfword 20.0, 21.0, 22.0, 23.0, 24.0
        .code
        operands
; The index list consists of words; the indices count half words.
        descriptor va, list, n
        EX      vb, table
        into    gathered
        VXTOV,H [va], [vb], [to]
; expect-halves: [gathered] = 23.0, 20.0, X'0ABC DEF1', 22.0, 24.0
        into    gathered_some
        VXTOV,H [va, once], [vb], [to, by] ? [vz]
; expect-halves: [gathered_some] = kept, kept, X'0ABC DEF1', 22.0, kept
        descriptor vb, a, n
        into    scattered
        EX      to, scattered + 32
        VTOVX,H [va], [vb], [to]
; expect-halves: [scattered] = 3.0, 2.0, kept, 4.0, 1.0, 5.0
        into    scattered_some
        EX      to, scattered_some + 32
        VTOVX,H [va], x, [to] ? [vz]
; expect-halves: [scattered_some] = 3.0, kept, kept, 3.0, 3.0
; A period also counts half words, and it is in a whole register.
        .regs   r64, period
        ES      period, 2
        EX      vb, table
        into    gathered_second
        ELEN    to, 3
        VGATHP,H period, [vb], [to]
; expect-halves: [gathered_second] = 20.0, 22.0, 24.0, kept, kept
        ES      period, -1
        descriptor vb, a, n
        into    scattered_back
        EX      to, scattered_back + 4*32
        VSCATP,H period, [vb], [to] ? [vz]
; expect-halves: [scattered_back] = kept, 4.0, 3.0, kept, 1.0
        descriptor va, a, n
        descriptor vb, b, n
        into    masked
        MASKV,H [va], [vb], [to] ? [vz]
; expect-halves: [masked] = 1.0, -2.0, 3.0, 4.0, -5.0
        into    masked_scalar
        MASKV,H x, [vb], [to] ?! [vz]
; expect-halves: [masked_scalar] = -1.0, 3.0, -3.0, -4.0, 3.0
        into    merged
        MRGV,H  [va], [vb], [to] ? [vz]
; expect-halves: [merged] = 1.0, -1.0, 2.0, 3.0, -2.0
        into    merged_short            ; padded with machine zeros
        ELEN    va, 2
        MRGV,H  [va], y, [to] ? [vz]
        ELEN    va, n
; expect-halves: [merged_short] = 1.0, 0.5, 2.0, 0.0, 0.5
; The machine sets the length of the result.
        into    compressed
        CPSV,H  [va], [to] ? [vz]
        LTOR    to, r60
; expect-halves: [compressed] = 1.0, 3.0, 4.0, kept, kept
; expect: r60 = 3
        into    compressed_scalar
        CPSV,H  x, [to, by] ?! [vz]
        LTOR    to, r61
; expect-halves: [compressed_scalar] = kept, 3.0, 3.0, kept, kept
; expect: r61 = 2
        .data
order:  .word   -1
        .code
        into    sieved
        EX      r62, order
        ACPSV,H [va], x, [to], [r62]
        LTOR    to, r63
; expect-halves: [sieved] = 3.0, 4.0, 5.0, kept, kept
; expect-bits: [order + 16] = 1111
; expect: r63 = 3
; Both numbers are half registers.
        into    interval
        INTVLV,H x, y, [to]
; expect-halves: [interval] = 3.0, 3.5, 4.0, 4.5, 5.0
        into    interval_some
        INTVLV,H -x, y, [to, by] ? [vz]
; expect-halves: [interval_some] = kept, kept, -2.5, X'EBC0 0000', kept
; 2 x^2 - x + 0.5
        odd
coefficients:
        .halfword 2.0, -1.0, 0.5
        .code
        descriptor vb, coefficients, 3
        into    polynomial
        POLYV,H [va], [vb], [to]
; expect-halves: [polynomial] = 1.5, 6.5, 15.5, 28.5, 45.5
        into    polynomial_scalar
        POLYV,H x, [vb, once], [to] ? [vz]
; expect-halves: [polynomial_scalar] = -2.5, kept, -2.5, -2.5, kept
        EXIT
; expect-flags: X'0000 0000 0000 0000'
