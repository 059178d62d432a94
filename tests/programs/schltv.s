; SCHLTV: C(i) := index of the first B for which A(i) < B, or the length of
; B

        .include "search.inc"

        uses    SCHLTV
; expect: [plain] = 1, 1, 5, 1, 5, 5
; expect: [broadcast] = 1, 1, 1, 1, 1, 1
; expect: [where_ones] = 1, 9.0, 5, 1, 9.0, 9.0
; expect: [where_zeros] = 9.0, 1, 9.0, 9.0, 5, 5
; expect: [offset_sources] = 0, 3, 1, 3, 3, 1
; expect: [offset_result] = 9.0, 9.0, 1, 5, 9.0, 9.0
; expect: [short_source] = 1, 1, 5, 1, 1, 1
; expect: [negated] = 1, 1, 0, 1, 5, 0
; expect: [magnitudes] = 0, 1, 5, 0, 5, 5
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [nowhere] = 0, 0, 0, 0, 0, 0

        overlap SCHLTV
; expect: [chain] = 4, 0, 0, 1.0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
