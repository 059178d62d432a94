; A vector in page 0 changes no register.
        .include "../vector.inc"
        descriptor va, 64, n
        ES      value, 7
        DOTV    [va], [va], value
; expect-trap: unmapped-address
; expect: r32 = 7
