; Results and clocks are compared with those worked out by hand from the timing of
; docs/timing.md.
; MPYSV and SQRTV of half words run as one stream: a geometric mean.
        .equ    n, 6
        .regs   r10, va, vb, result
        .data
        .halfvector a, n, 1.0, 2.0, 4.5, 25.0, 0.0, 3.0
        .halfvector b, n, 4.0, 8.0, 2.0, 1.0, 2.0, 12.0
c:      .space  n / 2
        .code
        EX      va, a                   ; at 0
        ELEN    va, n
        EX      vb, b
        ELEN    vb, n
        EX      result, c
        ELEN    result, n
        LINKV                           ; at 6
        MPYSV,H [va], [vb], [result]
        SQRTV,H [result], [result]
        EXIT
; expect-halves: [c] = 2.0, 4.0, 3.0, 5.0, X'8000 0000', 6.0
; expect-flags: X'0000 0000 0010 0000'
; Clocks: start-up 84 + (80 - 51), by which a root exceeds an addition; page 30 + 1,000;
; six elements at 0.8125 are 4.875, rounded to 5.
; expect-clocks: 6 + 84 + 29 + 1030 + 5
; expect-model: cyber205-2pipe-prior
