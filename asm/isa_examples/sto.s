        .data
table:  .word   1.5, 2.5, 3.5
        .code
        EX      r10, table
        ES      r11, 2
        ES      r12, 7
        STO     [r10, r11], r12
        EXIT
; expect: [table] = 1.5, 2.5, 7
