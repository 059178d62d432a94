; test: -17.9 degrees Celsius: below 0 in Fahrenheit, where truncation is not the floor
; tolerance: fahrenheit 1e-9

        .warm
        .data
tenths: .word   -179
want_fahrenheit:
        .word   -0.22
want_whole:
        .word   -1
