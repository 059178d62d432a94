; MINV: C := least A; C+1 := its index

        .include "reduce.inc"

        .data
a:      .word   1.0, -200.0, 3.0, 100.0, 100.0, -200.0
scalars:
        .word   0.0, 0.0
        .bitvector z, n, "101100"
        .code

; the first of equals; the index stands in the word after
        uses    MINV
; expect: [plain] = -200.0, 1
; expect: [where_ones] = 1.0, 0
; expect: [where_zeros] = -200.0, 1
; counted from the first element after the offset
; expect: [offset_source] = -200.0, 3

        signs   MINV
; expect: [negated] = -100.0, 3
; expect: [magnitudes] = 1.0, 0
; expect: [negative] = -200.0, 1

        EXIT
; expect-flags: X'0000 0000 0000 0000'
