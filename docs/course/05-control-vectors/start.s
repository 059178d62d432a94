; start.s - a tax of two rates for many incomes.

        .include "core.s"

        .ifndef n
        .equ    n, 6                    ; the tests define it
        .endif

        .data
limit:  .word   1000.0
low:    .word   0.25                    ; the rate up to the limit
high:   .word   0.5                     ; the rate above it
income:
        .rept   n
        .word   500.0 * float(\+)
        .endr
tax:    .space  n
above:  .space  1                       ; incomes that reach the limit, an integer
        .bitvector rich, n
        .code

        .regs   r10, address, bound, low_rate, high_rate, excess, count
        .regs   r20, incomes, taxes, riches, link

        EX      address, limit
        LOD     [address], bound
        EX      address, low
        LOD     [address], low_rate
        EX      address, high
        LOD     [address], high_rate
        descriptor incomes, income, n
        descriptor taxes, tax, n
        descriptor riches, rich, n

        ; your code here, in place of this line
        ES      count, 0

        EX      address, above
        STO     [address], count
        EXIT
; expect: [tax] = 0.0, 125.0, 250.0, 500.0, 750.0, 1000.0
; expect: [above] = 4
