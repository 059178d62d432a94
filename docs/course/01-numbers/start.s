; start.s - degrees Fahrenheit of an integer of tenths of a degree Celsius.

        .include "core.s"

        .data
tenths: .word   215                     ; 21.5 degrees Celsius, an integer
fahrenheit:
        .space  1                       ; the same in Fahrenheit, a normalised number
whole:  .space  1                       ; the whole degrees not above it, an integer
        .code

        .regs   r10, address, t, nine, fifty, offset, degrees, floor

        EX      address, tenths
        LOD     [address], t
        load_constant nine, 9.0
        load_constant fifty, 50.0
        load_constant offset, 32.0

        ; your code here, in place of two lines: from t to degrees and floor
        ES      degrees, 0
        ES      floor, 0

        EX      address, fahrenheit
        STO     [address], degrees
        EX      address, whole
        STO     [address], floor
        EXIT
