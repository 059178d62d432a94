        .data
table:  .halfword 1.5, 2.5, 3.5
        .code
        EX      r10, table
        ES      r11, 1
        EXH     h24, 7
        STOH    [r10, r11], h24
        EXIT
; expect-halves: [table] = 1.5, 7, 3.5
