; example-range.s - how many elements are from 1 up to 2.

        .include "print.s"

        .ifndef n
        .equ    n, 1000
        .endif

        .data
x:
        .rept   n
        .word   float(\+) / 100
        .endr
        .bitvector low, n
        .bitvector high, n
        .code

        .regs   r10, xs, lows, highs, one, two, count

        load_constant one, 1.0
        load_constant two, 2.0
        descriptor xs, x, n
        descriptor lows, low, n
        descriptor highs, high, n

        CMPGEV  [xs], one, [lows]
        CMPLTV  [xs], two, [highs]
        ANDB    [lows], [highs], [lows] ; both
        CNTOB   [lows], count
        print_integer count
        newline
        EXIT
; expect-print: 100
