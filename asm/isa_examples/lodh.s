        .data
table:  .halfword 1.5, 2.5, 3.5
        .code
        EX      r10, table
        ES      r11, 2
        LODH    [r10, r11], h24
        EXIT
; expect: h24 = 3.5
