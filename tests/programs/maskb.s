; MASKB: C := A where Z has ones, B where it has zeros

        .include "string.inc"

        .data
picks:  .word   X'FF00 F0F0 0000 FFFF', X'F000 FFFF 0000 0000'
        .code

        .macro  strings
        descriptor va, first, 100
        descriptor vb, second, 100
        EX      vz, picks               ; its length does not count
        .endm

        strings
        ES      by, 8
        into_string long, 100
        MASKB   [va], [vb], [to] ? [vz]
        into_string where_zeros, 16
        MASKB   [va], [vb], [to] ?! [vz]
        into_string offset, 24          ; of the control vector, too
        MASKB   [va], [vb], [to, by] ? [vz]
        into_string any_bit, 13         ; strings begin at any bit
        IX      va, 5
        IX      vb, 3
        IX      vz, 4
        IX      to, 7
        MASKB   [va], [vb], [to] ? [vz]
        ELEN    va, 4                   ; zeros follow
        ELEN    vb, 9
        into_string short_sources, 16
        MASKB   [va], [vb], [to] ? [vz]
        into_string nothing, 0
        MASKB   [va], [vb], [to] ? [vz]
; expect: [long] = X'0F33 1F3F 0000 9ABC', X'FF00 0000 FFFF FFFF'
; expect-bits: [where_zeros] = 00110011000011111111
; expect-bits: [offset] = 1111111100110011000000111111
; expect-bits: [any_bit] = 111111111101001100101111
; expect-bits: [short_sources] = 11101001100000001111
; expect-bits: [nothing] = 11111111

        strings
        into_string source_offset, 16   ; A and B from bit 8 on
        MASKB   [va, by], [vb, by], [to] ? [vz]
; expect-bits: [source_offset] = 00001111111111111111

; Each bit is made from the one before.
        .data
chain:  .word   X'8000 0000 0000 0000'
        .code
        descriptor va, chain, 8
        descriptor to, chain + 1, 8
        MASKB   [va], [vb], [to] ? [vz]
; expect: [chain] = X'FF80 0000 0000 0000'

        EXIT
; expect-flags: X'0000 0000 0000 0000'
; expect-warning: zero-length
