; MAXV: C := greatest A; C+1 := its index

        .include "reduce.inc"

        .data
a:      .word   1.0, -200.0, 3.0, 100.0, 100.0, -200.0
scalars:
        .word   0.0, 0.0
        .bitvector z, n, "101100"
        .code

; the first of equals; the index stands in the word after
        uses    MAXV
; expect: [plain] = 100.0, 3
; expect: [where_ones] = 100.0, 3
; expect: [where_zeros] = 100.0, 4
; counted from the first element after the offset
; expect: [offset_source] = 100.0, 1

        signs   MAXV
; expect: [negated] = 200.0, 1
; expect: [magnitudes] = 200.0, 1
; expect: [negative] = -1.0, 0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
