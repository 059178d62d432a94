; vector_add.s - additions of LENGTH elements, one after the other has ended.
;
; Their time alone, without what hides under the stream of the one before: a
; store waits for each.  With LENGTH = 0 that is the start-up; with the length of
; half the greatest rate, n-half, they make half as many results.

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
        STO     [waited_at], r0         ; the first touch of the page
        .rept   TIMES
        .kernel add
        ADDNV   [numbers_at], [numbers_at], [results_at]
        .endkernel
        STO     [waited_at], r0
        .endr
        EXIT
; expect: numbers_at = word(LENGTH << 48 | numbers)
; expect-warning: zero-length
