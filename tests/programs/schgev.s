; SCHGEV: C(i) := index of the first B for which A(i) >= B, or the length of
; B

        .include "search.inc"

        uses    SCHGEV
; expect: [plain] = 0, 0, 0, 0, 5, 0
; expect: [broadcast] = 0, 0, 0, 0, 0, 0
; expect: [where_ones] = 0, 9.0, 0, 0, 9.0, 9.0
; expect: [where_zeros] = 9.0, 0, 9.0, 9.0, 5, 0
; expect: [offset_sources] = 3, 0, 0, 3, 0, 0
; expect: [offset_result] = 9.0, 9.0, 0, 0, 9.0, 9.0
; expect: [short_source] = 0, 0, 0, 0, 0, 0
; expect: [negated] = 0, 0, 5, 0, 5, 5
; expect: [magnitudes] = 2, 0, 0, 2, 5, 0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [nowhere] = 0, 0, 0, 0, 0, 0

        overlap SCHGEV
; expect: [chain] = 0, 0, 0, 1.0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
