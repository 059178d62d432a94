; MRGB: C := the next bit of A where Z has ones, the next of B where it has
; zeros

        .include "string.inc"

        .data
picks:  .word   X'FF00 F0F0 0000 FFFF', X'F000 FFFF 0000 0000'
halves: .word   X'0000 0000 0000 0000', X'FFFF FFFF FFFF FFFF'
        .code

        .macro  strings
        descriptor va, first, 100
        descriptor vb, second, 100
        EX      vz, picks + 12          ; 0000 1111 0000 1111 0000 0000
        .endm

        strings
        ES      by, 8
        into_string plain, 16
        MRGB    [va], [vb], [to] ? [vz]
        into_string where_zeros, 16
        MRGB    [va], [vb], [to] ?! [vz]
        into_string offset, 24          ; of the control vector, too
        MRGB    [va], [vb], [to, by] ? [vz]
        into_string source_offset, 16   ; A and B from bit 8 on
        MRGB    [va, by], [vb, by], [to] ? [vz]
        IX      va, 5
        IX      vb, 3
        ELEN    va, 4                   ; zeros follow
        ELEN    vb, 6
        into_string short_sources, 16
        MRGB    [va], [vb], [to] ? [vz]
        into_string nothing, 0
        MRGB    [va], [vb], [to] ? [vz]
; expect-bits: [plain] = 00110000001111111111
; expect-bits: [where_zeros] = 00000011111100111111
; expect-bits: [offset] = 1111111100110000001100111111
; expect-bits: [source_offset] = 00110000001111111111
; expect-bits: [short_sources] = 10011110100000001111
; expect-bits: [nothing] = 11111111

        strings
        EX      vz, halves
        into_string long, 100
        MRGB    [va], [vb], [to] ? [vz]
; expect: [long] = X'3333 FFFF 0000 FFFF', X'0F0F 1234 5FFF FFFF'

; Each bit is made from the second before it.
        .data
chain:  .word   X'8000 0000 0000 0000'
        .code
        EX      vz, halves + 64
        descriptor va, chain, 8
        descriptor to, chain + 2, 8
        MRGB    [va], [vb], [to] ? [vz]
; expect: [chain] = X'AA80 0000 0000 0000'

        EXIT
; expect-flags: X'0000 0000 0000 0000'
; expect-warning: zero-length
