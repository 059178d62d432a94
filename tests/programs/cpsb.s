; CPSB: C := those bits of A where Z has ones; length of C := their number

        .include "string.inc"

        .data
picks:  .word   X'FF00 F0F0 0000 FFFF', X'F000 FFFF 0000 0000'
ones:   .word   X'FFFF FFFF FFFF FFFF', X'FFFF FFFF FFFF FFFF'
second_ones: .word X'5555 5555 5555 5555'
        .code

        descriptor va, first, 100
        descriptor vz, picks, 16        ; 8 ones, 8 zeros
        ES      by, 8
        into_string plain, 1000         ; its length does not count
        CPSB    [va], [to] ? [vz]
        LTOR    to, r40
        into_string where_zeros, 0
        CPSB    [va], [to] ?! [vz]
        LTOR    to, r41
        into_string offset, 0           ; of the control vector, too
        CPSB    [va], [to, by] ?! [vz]
        LTOR    to, r42
        into_string source_offset, 0
        CPSB    [va, by], [to] ? [vz]
        ELEN    va, 6                   ; zeros follow
        into_string short_source, 0
        CPSB    [va], [to] ? [vz]
        LTOR    to, r43
; expect-bits: [plain] = 000011111111
; expect-bits: [where_zeros] = 000011111111
; expect-bits: [offset] = 11111111000011111111
; expect-bits: [source_offset] = 000011111111
; expect-bits: [short_source] = 000011001111
; expect: r40 = 8
; expect: r41 = 8
; expect: r42 = 8
; expect: r43 = 8

        descriptor va, first + 5, 95
        descriptor vz, picks + 12, 28   ; 0000 1111 0000 1111 0000 0000 0000
        into_string any_bit, 0          ; strings begin at any bit
        IX      to, 3
        CPSB    [va], [to] ? [vz]
        descriptor va, first, 100
        descriptor vz, ones, 100
        into_string long, 0
        CPSB    [va], [to] ? [vz]
        LTOR    to, r44
        ELEN    vz, 0
        into_string nothing, 5
        CPSB    [va], [to] ? [vz]
        LTOR    to, r45
        CPSB    [va], [r0] ? [vz]
; expect-bits: [any_bit] = 111000100101111
; expect: [long] = X'0F0F 1234 5678 9ABC', X'FFFF 0000 FFFF FFFF'
; expect-bits: [nothing] = 11111111
; expect: r44 = 100
; expect: r45 = 0
; expect: r0 = 0

; A result may lie over its source; what it overwrites there is read no more,
; unless it lies behind.
        .data
in_place: .word X'3CFF 0000 0000 0000'
chain:  .word   X'8000 0000 0000 0000'
        .code
        descriptor vz, second_ones, 8
        descriptor to, in_place, 8
        CPSB    [to], [to] ? [vz]
        descriptor vz, ones, 8
        descriptor va, chain, 8
        descriptor to, chain + 1, 8
        CPSB    [va], [to] ? [vz]
; expect: [in_place] = X'6CFF 0000 0000 0000'
; expect: [chain] = X'FF80 0000 0000 0000'

        EXIT
; expect-flags: X'0000 0000 0000 0000'
