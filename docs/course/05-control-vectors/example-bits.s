; example-bits.s - a comparison makes bits; bits say where to store.

        .include "print.s"

        .equ    n, 8

        .data
        .vector x, n, 3.0, -1.0, 4.0, -1.0, -5.0, 9.0, -2.0, 6.0
        .vector y, n
        .bitvector z, n
        .code

        .regs   r10, xs, ys, zs, ten

        load_constant ten, 10.0
        descriptor xs, x, n
        descriptor ys, y, n
        descriptor zs, z, n             ; its length counts bits

        CMPLTV  [xs], r0, [zs]          ; bit i := x < 0
        print_bits zs
        newline
        ADDNV   [xs], ten, [ys]         ; all
        print_vector ys
        newline
        VTOV    r0, [ys] ? [zs]         ; 0 where the bit is one
        print_vector ys
        newline
        VTOV    ten, [ys] ?! [zs]       ; 10 where it is zero
        print_vector ys
        newline
        EXIT
; expect-print: 01011010
; expect-print: 13 9 14 9 5 19 8 16
; expect-print: 13 0 14 0 0 19 0 16
; expect-print: 10 0 10 0 0 10 0 10
