; test: 0 degrees Celsius, an integer of no digits
; tolerance: fahrenheit 1e-9

        .warm
        .data
tenths: .word   0
want_fahrenheit:
        .word   32.0
want_whole:
        .word   32
