; The table lies on words.
        .include "../vector.inc"
        .data
table:  .word   9.0, 9.0, 9.0, 9.0, 9.0, 9.0
b:      .word   1.0, 2.0, 3.0
        .code
        descriptor vb, b, 3
        EX      to, table + 32
        ES      value, 1
        VSCATP  value, [vb], [to]
; expect-trap: misaligned-operand
; expect: [table] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
