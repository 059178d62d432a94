; Results and clocks are compared with those worked out by hand from the timing of
; docs/timing.md.
; A recurrence in a linked pair: its elements wait for the whole pair, whichever of
; the two instructions reads them.
        .equ    n, 4
        .regs   r10, ahead, behind, handed
        .data
a:      .word   1.0, 16.0, 0.0, 0.0, 0.0
        .code
        EX      ahead, a                ; at 0
        ELEN    ahead, n
        EX      behind, a + 64
        ELEN    behind, n
        RTOR    ahead, handed
        LINKV                           ; at 5
        SQRTV   [behind], [handed]
        ADDNV   [handed], [ahead], [behind]
        EXIT
; The roots of 16 and 1, then the root of 0 and of elements stored before.
; expect: [a] = 1.0, 5.0, 5.0, 5.0, 5.0
; expect-flags: X'0000 0000 0010 0000'
; expect-warning: recurrence
; Clocks: start-up 84 + 80 - 51, page 30 + 1,000, four elements at 1.625 are 6.5,
; rounded to 7, and three of them wait a start-up each.
; expect-clocks: 5 + 113 + 1030 + 7 + 3 * 113
; expect-model: cyber205-2pipe-prior
