        EX      r10, 0x123456789ABC
        EXIT
; expect: r10 = X'0000 1234 5678 9ABC'
