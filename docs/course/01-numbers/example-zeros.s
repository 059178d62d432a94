; example-zeros.s - the sum of 0.001 and a zero of .space, and of 0.001 and 0.0.

        .include "print.s"
        .regs   r10, address, x, zero, sum

        .data
empty:  .space  1
        .code

        load_constant x, 0.001
        EX      address, empty
        LOD     [address], zero
        ADDN    x, zero, sum
        print_number sum
        newline
        load_constant zero, 0.0
        ADDN    x, zero, sum
        print_number sum
        newline
        EXIT
; expect-print: 0.00099999999999767
; expect-print: 0.001
