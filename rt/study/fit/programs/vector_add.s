; vector_add.s - adds vectors of LENGTH elements, each after the end of the
; last.
;
; A store waits for each addition, so none overlaps the stream of the one before
; it.  With LENGTH = 0 the time is the start-up.  With LENGTH = n-half the rate
; of results is half of the maximum rate.

        .ifndef LENGTH
        .equ    LENGTH, 0
        .endif
        .equ    TIMES, 100
        .equ    FLOPS, LENGTH * TIMES

        .data
numbers:        .space 1024
results:        .space 1024
waited:         .space 1
        .code

        .regs   r10, numbers_at, results_at, waited_at

        EX      numbers_at, numbers
        ELEN    numbers_at, LENGTH
        EX      results_at, results
        ELEN    results_at, LENGTH
        EX      waited_at, waited
        STO     [waited_at], r0         ; touches the page for the first time
        .rept   TIMES
        .kernel add
        ADDNV   [numbers_at], [numbers_at], [results_at]
        .endkernel
        STO     [waited_at], r0
        .endr
        EXIT
; expect: numbers_at = word(LENGTH << 48 | numbers)
; expect-warning: zero-length
