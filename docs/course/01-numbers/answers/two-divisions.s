; two-divisions.s - degrees Fahrenheit by two divisions: tenths to degrees, and nine fifths of them.

        .include "core.s"

        .data
tenths: .word   215                     ; 21.5 degrees Celsius
fahrenheit:
        .space  1
whole:  .space  1
        .code

        .regs   r10, address, t, ten, nine, five, offset, degrees, floor

        EX      address, tenths
        LOD     [address], t
        load_constant nine, 9.0
        load_constant ten, 10.0
        load_constant five, 5.0
        load_constant offset, 32.0
        ADDN    t, r0, t
        DIVS    t, ten, t
        MPYS    t, nine, t
        DIVS    t, five, t
        ADDN    t, offset, degrees
        FLR     degrees, floor
        EX      address, fahrenheit
        STO     [address], degrees
        EX      address, whole
        STO     [address], floor
        EXIT
; expect: [fahrenheit] = 70.7 ~ 1e-9
; expect: [whole] = 70
