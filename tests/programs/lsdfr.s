; The data flag register is compared with the flags of a divide fault and of stores.
; tests: LSDFR
; LSDFR: T := data flag register; data flag register := R

        .include "scalar.inc"

        ES      r40, 5
        fetch   left, 1.0
        DIVU    left, r0, result        ; divide fault, indefinite
        LSDFR   r40, r41
        LSDFR   r0, r42                 ; register 0 clears them
        LSDFR   r0, r43
        RTOR    r41, r44
        LSDFR   r44, r44                ; one register for both
        LSDFR   r44, r45
        fetch   left, X'8000 0000 0000 0001'
        LSDFR   left, r0
; expect: r41 = X'0000 0000 0042 0000'
; expect: r42 = 5
; expect: r43 = 0
; expect: r44 = 0
; expect: r45 = X'0000 0000 0042 0000'
; expect: r0 = 0
        EXIT
; expect-flags: X'8000 0000 0000 0001'
