; Where both sources are broadcast, there is no length.
        ES      r11, 7
        .half   X'C018 000A', X'000A 000B' ; SELEQV r10, r10, r11
; expect-trap: bad-descriptor
; expect: r11 = 7
