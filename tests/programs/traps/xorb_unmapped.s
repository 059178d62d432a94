; A string in page 0.
        .include "../vector.inc"
        descriptor va, 64, n
        into_bits nothing
        XORB    [va], [va], [to]
; expect-trap: unmapped-address
; expect-bits: [nothing] = 111111
