; Results of instructions with one source on half word vectors are compared with half
; words worked out by hand.  A wrong rounding, neighbour or size of an element makes one
; differ.
; Vectors of half words: instructions with one source.

        .include "half_vector.inc"

        .macro  uses op
        into    \op\().plain
        \op,H   [va], [to]
        into    \op\().broadcast
        \op,H   x, [to] ?! [vz]
        into    \op\().offset           ; of source, result, control vector
        \op,H   [va, once], [to, by] ? [vz]
        .endm

        five    a, 2.75, -2.75, 16.0, -0.5, 0.1
b:
scalars:
        .halfword -6.25, 0.0
        five    squares, 4.0, 2.0, 0.0625, 16, 0.0
        .code
        operands
        uses    TRUV
; expect-halves: [TRUV.plain] = 2, -2, 16, 0, 0
; expect-halves: [TRUV.broadcast] = kept, -6, kept, kept, -6
; expect-halves: [TRUV.offset] = kept, kept, 16, 0, kept
        uses    FLRV
; expect-halves: [FLRV.plain] = 2, -3, 16, -1, 0
; expect-halves: [FLRV.broadcast] = kept, -7, kept, kept, -7
; expect-halves: [FLRV.offset] = kept, kept, 16, -1, kept
        uses    CLGV
; expect-halves: [CLGV.plain] = 3, -2, 16, 0, 1
; expect-halves: [CLGV.broadcast] = kept, -6, kept, kept, -6
; expect-halves: [CLGV.offset] = kept, kept, 16, 0, kept
        uses    VTOV
; expect-halves: [VTOV.plain] = 2.75, -2.75, 16.0, -0.5, 0.1
; expect-halves: [VTOV.broadcast] = kept, -6.25, kept, kept, -6.25
; expect-halves: [VTOV.offset] = kept, kept, 16.0, -0.5, kept
        uses    ABSV
; expect-halves: [ABSV.plain] = 2.75, 2.75, 16.0, 0.5, 0.1
; expect-halves: [ABSV.broadcast] = kept, 6.25, kept, kept, 6.25
; expect-halves: [ABSV.offset] = kept, kept, 16.0, 0.5, kept
        uses    EXPV
; expect-halves: [EXPV.plain] = -21, -21, -18, -24, -26
; expect-halves: [EXPV.broadcast] = kept, -20, kept, kept, -20
; expect-halves: [EXPV.offset] = kept, kept, -18, -24, kept
        uses    VREVV
; expect-halves: [VREVV.plain] = 0.1, -0.5, 16.0, -2.75, 2.75
; expect-halves: [VREVV.broadcast] = kept, -6.25, kept, kept, -6.25
; expect-halves: [VREVV.offset] = kept, kept, -0.5, 16.0, kept
        uses    ADJMV                   ; the last with machine zero
; expect-halves: [ADJMV.plain] = 0.0, 6.625, 7.75, X'E799 9999', X'E566 6666'
; expect-halves: [ADJMV.broadcast] = kept, -6.25, kept, kept, -6.25
; expect-halves: [ADJMV.offset] = kept, kept, 7.75, X'E799 9999', kept
        uses    DELTAV
; expect-halves: [DELTAV.plain] = -5.5, 18.75, -16.5, X'E94C CCCC', X'E699 999A'
; expect-halves: [DELTAV.broadcast] = kept, 0.0, kept, kept, 0.0
; expect-halves: [DELTAV.offset] = kept, kept, -16.5, X'E94C CCCC', kept
; Machine zeros follow a short source; sign control takes it first.
        into    short
        VTOV,H  -|[short_a]|, [to]
; expect-halves: [short] = -2.75, -2.75, -16.0, 0.0, 0.0
; 16 has 5 significant bits, so its root has.
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
