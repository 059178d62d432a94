        ES      r10, 42
        EXIT    r10, r0, 2              ; print an integer
        EXIT    r0, r0, 5               ; end the line
        EXIT                            ; end the program
; expect-print: 42
