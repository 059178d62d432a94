; The third index leads to page 0: nothing is gathered.
        .include "../vector.inc"
        .data
table:  .word   1.0, 2.0
a:      .word   0, 1, 0, 0, 1, 1
        .code
        descriptor va, a, n
        EX      vb, table
        EX      place, a + 2 * 64
        EX      value, -(table / 64)
        STO     [place], value
        no_result
        VXTOV   [va], [vb], [to]
; expect-trap: unmapped-address
