; Results of instructions with one source on half word vectors are compared with half
; words worked out by hand.  A wrong rounding, neighbour or element size makes one
; differ.
; Vectors of half words: instructions with one source.

        .include "half_vector.inc"

; Scalar: the result for the scalar; e0 .. e4: the results for the elements of a.
        .macro  uses op, scalar, e0, e1, e2, e3, e4
        into    \op\().plain
        \op,H   [va], [to]
; expect-halves: [\op\().plain] = \e0, \e1, \e2, \e3, \e4
        into    \op\().broadcast
        \op,H   x, [to] ?! [vz]
; expect-halves: [\op\().broadcast] = kept, \scalar, kept, kept, \scalar
        into    \op\().offset           ; offsets of source, result and control vector
        \op,H   [va, once], [to, by] ? [vz]
        .endm

        .macro  elementwise op, scalar, e0, e1, e2, e3, e4
        uses    \op, \scalar, \e0, \e1, \e2, \e3, \e4
; expect-halves: [\op\().offset] = kept, kept, \e2, \e3, kept
        .endm

        five    a, 2.75, -2.75, 16.0, -0.5, 0.1
b:
scalars:
        .halfword -6.25, 0.0
        five    squares, 4.0, 2.0, 0.0625, 16, 0.0
        .code
        operands
        elementwise TRUV, -6, 2, -2, 16, 0, 0
        elementwise FLRV, -7, 2, -3, 16, -1, 0
        elementwise CLGV, -6, 3, -2, 16, 0, 1
        elementwise VTOV, -6.25, 2.75, -2.75, 16.0, -0.5, 0.1
        elementwise ABSV, 6.25, 2.75, 2.75, 16.0, 0.5, 0.1
        elementwise EXPV, -20, -21, -21, -18, -24, -26
        uses    VREVV, -6.25, 0.1, -0.5, 16.0, -2.75, 2.75
; expect-halves: [VREVV.offset] = kept, kept, -0.5, 16.0, kept
        elementwise ADJMV, -6.25, 0.0, 6.625, 7.75, X'E799 9999', X'E566 6666' ; padded with machine zero
        elementwise DELTAV, 0.0, -5.5, 18.75, -16.5, X'E94C CCCC', X'E699 999A'
; A short source is padded with machine zeros after its signs are changed.
        into    short
        VTOV,H  -|[short_a]|, [to]
; expect-halves: [short] = -2.75, -2.75, -16.0, 0.0, 0.0
; 16 has 5 significant bits, so its root has 5 significant bits.
        descriptor va, squares, n
        into    roots
        SQRTV,H [va], [to]
; expect-halves: [roots] = 2.0, X'EA5A 8279', 0.25, X'FE00 0010', 0.0
        load    x, squares
        into    root
        SQRTV,H x, [to] ? [vz]
; expect-halves: [root] = 2.0, kept, 2.0, 2.0, kept
        EXIT
; expect-flags: X'0000 0000 0010 0000'
