; test: 21.5 degrees Celsius
; tolerance: fahrenheit 1e-9
; goals: gold 95, silver 110, bronze 300

        .warm
        .data
tenths: .word   215
want_fahrenheit:
        .word   70.7
want_whole:
        .word   70
