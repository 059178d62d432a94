        EXH     h20, -2                 ; the left half of r10
        EXH     h21, 5                  ; the right half
        EXIT
; expect: h20 = -2
; expect: r10 = X'00FF FFFE 0000 0005'
