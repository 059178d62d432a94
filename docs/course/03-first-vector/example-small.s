; example-small.s - two vectors of five numbers.

        .include "print.s"

        .data
        .vector a, 5, 1.0, 2.0, 3.0, 4.0, 5.0
        .vector b, 5, 10.0, 20.0, 30.0, 40.0, 50.0
        .vector c, 5
        .code

        .regs   r10, as, bs, cs

        descriptor as, a, 5             ; a vector: where it begins, and its length
        descriptor bs, b, 5
        descriptor cs, c, 5
        ADDNV   [as], [bs], [cs]
        print_vector cs
        newline
        EXIT
; expect-print: 11 22 33 44 55
