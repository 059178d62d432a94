; gather.s - 20,000 elements gathered by random indices.
;
; Indices of 14 bits from J := 3125 J + 6925 mod 65536, which has the full
; period.  Each place of the table holds its own number, so that the result is
; the list of indices again.

        .equ    ELEMENTS, 20000
        .equ    TABLE, 16384

        .data
table:          .space TABLE
indices:        .space ELEMENTS
results:        .space ELEMENTS
        .code

        .regs   r10, at, index, left, step, increment, mask, place
        .regs   r17, one, minus, shift, indices_at, results_at
        .regs   r22, same, different

        EX      at, table
        ELEN    at, TABLE
        ES      one, 1
        ES      minus, -1
        INTVLV  r0, one, [at]           ; 0, 1, 2 ..
        EX      indices_at, indices
        ES      index, 1
        ES      step, 3125
        EX      increment, 6925
        EX      mask, 65535
        EX      left, ELEMENTS
next:   MPYX    index, step, index
        ADDX    index, increment, index
        AND     index, mask, index
        SHIFTI  index, -2, place
        STO     [indices_at], place
        IX      indices_at, 64
        IBXNE   left, minus, r0, next, left

        EX      at, table
        EX      indices_at, indices
        ELEN    indices_at, ELEMENTS
        EX      results_at, results
        ELEN    results_at, ELEMENTS
        VTOV    r0, [results_at]        ; the pages are there
        .kernel gather
        VXTOV   [indices_at], [at], [results_at]
        .endkernel
        SELNEV  [results_at], [indices_at], same
        EXIT
; expect: same = 20000
