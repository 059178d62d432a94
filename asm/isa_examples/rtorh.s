        EXH     h20, 5
        RTORH   h20, h23
        EXIT
; expect: r11 = X'0000 0000 0000 0005'
