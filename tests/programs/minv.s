; MINV: C := least A; B := its index

        .include "reduce.inc"

        .data
a:      .word   1.0, -200.0, 3.0, 100.0, 100.0, -200.0
scalars:
        .word   0.0, 0.0
        .bitvector z, n, "101100"
        .code

; the first of equals, counted over all elements; the index stands in the
; word after
        .macro  least source, result
        MINV    \source, index, \result
        .endm

        uses    least
; expect: [plain] = -200.0, 1
; expect: [where_ones] = 1.0, 0
; expect: [where_zeros] = -200.0, 1
; counted from the first element after the offset
; expect: [offset_source] = -200.0, 3

        signs   least
; expect: [negated] = -100.0, 3
; expect: [magnitudes] = 1.0, 0
; expect: [negative] = -200.0, 1

; Either may be left out; if both are one register the value stays.
        ES      value, 7
        MINV    [va], value, r0
        keep    index_alone
; expect: [index_alone] = 1
        ES      index, 7
        MINV    [va], r0, value
        keep    value_alone
; expect: [value_alone] = -200.0, 7
        MINV    [va], value, value
        keep    one_register
; expect: [one_register] = -200.0, 7

        EXIT
; expect-flags: X'0000 0000 0000 0000'
