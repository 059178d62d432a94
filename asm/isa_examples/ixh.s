        EXH     h20, 10
        IXH     h20, -3
        EXIT
; expect: h20 = 7
