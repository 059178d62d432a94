        EXH     h20, 3
        EXH     h21, -4
        ADJEH   h20, h21, h22
        EXIT
; expect: h22 = X'FC00 0030'
