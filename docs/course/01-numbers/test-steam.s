; test: 100 degrees Celsius are exactly 212 degrees Fahrenheit
; tolerance: fahrenheit 1e-9

        .warm
        .data
tenths: .word   1000
want_fahrenheit:
        .word   212.0
want_whole:
        .word   212
