; Results and clocks are compared with those worked out by hand from the timing of
; docs/timing.md.
; SHIFTV and ORV run as one stream: two words are packed into one, as programs did to
; halve the size of their data.
        .equ    n, 6
        .regs   r10, left, right, packed, half_word
        .data
lefts:  .word   1, 2, 3, X'0000 0000 8000 0000', X'0000 0000 FFFF FFFF', 0
rights: .word   X'0000 0000 0000 0007', 8, 9, 10, X'0000 0000 FFFF FFFF', 11
both:   .space  n
        .code
        EX      left, lefts             ; at 0
        ELEN    left, n
        EX      right, rights
        ELEN    right, n
        EX      packed, both
        ELEN    packed, n
        ES      half_word, 32
        LINKV                           ; at 7
        SHIFTV  [left], half_word, [packed]
        ORV     [packed], [right], [packed]
        EXIT
; expect: [both] = X'0000000100000007', X'0000000200000008', X'0000000300000009'
; expect: [both + 3*64] = X'800000000000000A', X'FFFFFFFFFFFFFFFF', 11
; expect-flags: X'0000 0000 0000 0000'
; Clocks: start-up 84, page 30 + 1,000, six elements on two pipes 3.
; expect-clocks: 7 + 84 + 1030 + 3
; expect-model: cyber205-2pipe-prior
