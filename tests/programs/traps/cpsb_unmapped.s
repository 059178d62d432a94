; Room is needed only for the bits that are kept, here for 8.
        .include "../string.inc"
        .data
picks:  .word   X'FF00 0000 0000 0000'
        .code
        descriptor va, first, 64
        descriptor vz, picks, 64
        EX      to, 0x7FFFFFF8
        CPSB    [va], [to] ? [vz]
; expect-trap: unmapped-address
; expect: r18 = 0x7FFFFFF8
