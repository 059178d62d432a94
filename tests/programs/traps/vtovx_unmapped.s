; The third index leads to page 0: nothing is scattered.
        .include "../vector.inc"
        .data
table:  .word   9.0, 9.0
a:      .word   0, 1, 0, 0, 1, 1
        .code
        descriptor va, a, n
        EX      to, table
        EX      place, a + 2 * 64
        EX      value, -(table / 64)
        STO     [place], value
        VTOVX   [va], [va], [to]
; expect-trap: unmapped-address
; expect: [table] = 9.0, 9.0
