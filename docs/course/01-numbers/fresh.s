; test: another temperature
; tolerance: fahrenheit 1e-9

        .warm
        .data
tenths: .word   draw * 7919 % 10007 - 2500
want_fahrenheit:
        .space  1
want_whole:
        .space  1
