; both-and-mask.s - a tax of two rates, both computed by the given formula, and a mask.

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
high_tax:
        .space  n
        .bitvector rich, n
        .code

        .regs   r10, address, bound, low_rate, high_rate, base, count
        .regs   r20, incomes, taxes, high_taxes, riches

        EX      address, limit
        LOD     [address], bound
        EX      address, low
        LOD     [address], low_rate
        EX      address, high
        LOD     [address], high_rate
        descriptor incomes, income, n
        descriptor taxes, tax, n
        descriptor riches, rich, n
        descriptor high_taxes, high_tax, n
        CMPGEV  [incomes], bound, [riches]
        MPYS    low_rate, bound, base
        MPYSV   [incomes], low_rate, [taxes]
        SUBNV   [incomes], bound, [high_taxes]
        MPYSV   [high_taxes], high_rate, [high_taxes]
        ADDNV   [high_taxes], base, [high_taxes]
        MASKV   [high_taxes], [taxes], [taxes] ? [riches]
        CNTOB   [riches], count
        EX      address, above
        STO     [address], count
        EXIT
; expect: [tax] = 0.0, 125.0, 250.0, 500.0, 750.0, 1000.0
; expect: [above] = 4
