; The second element would lie in page 0: nothing is gathered.
        .include "../vector.inc"
        .data
table:  .word   1.0
        .code
        EX      vb, table
        EX      value, -(table / 64)
        no_result
        VGATHP  value, [vb], [to]
; expect-trap: unmapped-address
