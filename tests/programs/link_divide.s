; Results and clocks are compared with those worked out by hand from the timing of
; docs/timing.md.
; DIVSV and ADDNV run as one stream, which has the additional start-up and the rate
; of a division.
        .equ    n, 6
        .regs   r10, dividend, divisor, result, three
        .data
a:      .word   1.0, -2.0, 3.0, 4.5, -0.5, 100.0
b:      .word   8.0, 0.5, -4.0, 4.5, 2.0, -0.25
c:      .space  n
        .code
        EX      dividend, a             ; at 0
        ELEN    dividend, n
        EX      divisor, b
        ELEN    divisor, n
        EX      result, c
        ELEN    result, n
        ES      three, 3
        LINKV                           ; at 7
        DIVSV   [dividend], [divisor], [result]
        ADDNV   [result], three, [result]
        EXIT
; expect: [c] = 3.125, -1.0, 2.25, 4.0, 2.75, -397.0
; expect-flags: X'0000 0000 0000 0000'
; Clocks: start-up 84 + (80 - 51), by which a division exceeds an addition; page
; 30 + 1,000; six elements at 1.625 are 9.75, rounded to 10.
; expect-clocks: 7 + 84 + 29 + 1030 + 10
; expect-model: cyber205-2pipe-prior
