; SCHEQV: C(i) := index of the first B = A(i), or the length of B

        .include "search.inc"

        uses    SCHEQV
; expect: [plain] = 3, 0, 1, 2, 5, 5
; expect: [broadcast] = 2, 2, 2, 2, 2, 2
; expect: [where_ones] = 3, 9.0, 1, 2, 9.0, 9.0
; expect: [where_zeros] = 9.0, 0, 9.0, 9.0, 5, 5
; expect: [offset_sources] = 3, 3, 0, 3, 3, 0
; expect: [offset_result] = 9.0, 9.0, 0, 1, 9.0, 9.0
; expect: [short_source] = 3, 0, 1, 2, 2, 2
; expect: [negated] = 5, 5, 5, 2, 5, 5
; expect: [magnitudes] = 3, 0, 1, 2, 5, 5
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [nowhere] = 0, 0, 0, 0, 0, 0

        overlap SCHEQV
; expect: [chain] = 1, 2, 0, 1.0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
