; MAXV: C := greatest A; B := its index

        .include "reduce.inc"

        .data
a:      .word   1.0, -200.0, 3.0, 100.0, 100.0, -200.0
scalars:
        .word   0.0, 0.0
        .bitvector z, n, "101100"
        .code

; the first of equals, counted over all elements; the index stands in the
; word after
        .macro  greatest source, result
        MAXV    \source, index, \result
        .endm

        uses    greatest
; expect: [plain] = 100.0, 3
; expect: [where_ones] = 100.0, 3
; expect: [where_zeros] = 100.0, 4
; counted from the first element after the offset
; expect: [offset_source] = 100.0, 1

        signs   greatest
; expect: [negated] = 200.0, 1
; expect: [magnitudes] = 200.0, 1
; expect: [negative] = -1.0, 0

; Either may be left out; if both are one register the value stays.
        ES      value, 7
        MAXV    [va], value, r0
        keep    index_alone
; expect: [index_alone] = 3
        ES      index, 7
        MAXV    [va], r0, value
        keep    value_alone
; expect: [value_alone] = 100.0, 7
        MAXV    [va], value, value
        keep    one_register
; expect: [one_register] = 100.0, 7

        .data
odd:    .word   1.0, X'7000 0000 0000 0003', 2.0
        .bitvector zeros, 3, "000"
        .code
        descriptor va, odd, 3
        MAXV    [va], index, value      ; as it stands
        keep    special
; expect: [special] = X'7000 0000 0000 0003', 1
        descriptor vz, zeros, 3
        MAXV    [va], index, value ? [vz]
        keep    held_back               ; nothing to look at
; expect: [held_back] = X'7000 0000 0000 0000', 3

        EXIT
; expect-flags: X'0000 0000 0002 0000'
