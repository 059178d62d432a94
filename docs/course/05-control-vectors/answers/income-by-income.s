; income-by-income.s - a tax of two rates, a loop with branches.

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
        .code

        .regs   r10, address, bound, low_rate, high_rate, base, count
        .regs   r20, income_at, tax_at, i, one, end, x

        EX      address, limit
        LOD     [address], bound
        EX      address, low
        LOD     [address], low_rate
        EX      address, high
        LOD     [address], high_rate
        EX      income_at, income
        EX      tax_at, tax
        MPYS    low_rate, bound, base
        ES      count, 0
        ES      i, 0
        ES      one, 1
        ES      end, n
next:   LOD     [income_at, i], x
        CFPLT   x, bound, poor
        SUBN    x, bound, x
        MPYS    x, high_rate, x
        ADDN    x, base, x
        IS      count, 1
        BIM     store
poor:   MPYS    x, low_rate, x
store:  STO     [tax_at, i], x
        IBXLT   i, one, end, next, i
        EX      address, above
        STO     [address], count
        EXIT
; expect: [tax] = 0.0, 125.0, 250.0, 500.0, 750.0, 1000.0
; expect: [above] = 4
