        EXH     h20, -22
        EXH     h21, 1 << 22
        PACKH   h20, h21, h22
        EXIT
; expect: h22 = 1.0
