; solution.s - degrees Fahrenheit of an integer of tenths of a degree Celsius.
;
; The integer is normalised first, so that nothing is lost; it is multiplied by a whole
; number, which is exact, before it is divided.

        .include "core.s"

        .data
tenths: .word   215                     ; 21.5 degrees Celsius
fahrenheit:
        .space  1
whole:  .space  1
        .code

        .regs   r10, address, t, nine, fifty, offset, degrees, floor

        EX      address, tenths
        LOD     [address], t
        load_constant nine, 9.0
        load_constant fifty, 50.0
        load_constant offset, 32.0
        ADDN    t, r0, t
        MPYS    t, nine, t
        DIVS    t, fifty, t
        ADDN    t, offset, degrees
        FLR     degrees, floor
        EX      address, fahrenheit
        STO     [address], degrees
        EX      address, whole
        STO     [address], floor
        EXIT
; expect: [fahrenheit] = 70.7 ~ 1e-9
; expect: [whole] = 70
