; example-small.s - compress a vector, process it, and merge the results back.

        .include "print.s"

        .equ    n, 8

        .data
        .vector x, n, 4.0, -1.0, 9.0, -1.0, -5.0, 16.0, -2.0, 25.0
        .vector few, n
        .vector y, n
        .bitvector z, n
        .code

        .regs   r10, xs, fews, ys, zs, count

        descriptor xs, x, n
        descriptor fews, few, n         ; room for the worst case
        descriptor ys, y, n
        descriptor zs, z, n

        CMPGEV  [xs], r0, [zs]
        CPSV    [xs], [fews] ? [zs]     ; the elements whose bit is one
        print_vector fews
        newline
        LTOR    fews, count             ; their number
        print_integer count
        newline
        SQRTV   [fews], [fews]          ; four elements, as fews has
        print_vector fews
        newline
        MRGV    [fews], r0, [ys] ? [zs] ; to their positions; 0 elsewhere
        print_vector ys
        newline
        EXIT
; expect-print: 4 9 16 25
; expect-print: 4
; expect-print: 2 3 4 5
; expect-print: 2 0 3 0 0 4 0 5
