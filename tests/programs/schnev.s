; SCHNEV: C(i) := index of the first B that A(i) is not, or the length of B

        .include "search.inc"

        uses    SCHNEV
; expect: [plain] = 0, 1, 0, 0, 0, 0
; expect: [broadcast] = 0, 0, 0, 0, 0, 0
; expect: [where_ones] = 0, 9.0, 0, 0, 9.0, 9.0
; expect: [where_zeros] = 9.0, 1, 9.0, 9.0, 0, 0
; expect: [offset_sources] = 0, 0, 1, 0, 0, 1
; expect: [offset_result] = 9.0, 9.0, 1, 0, 9.0, 9.0
; expect: [short_source] = 0, 1, 0, 0, 0, 0
; expect: [negated] = 0, 0, 0, 0, 0, 0
; expect: [magnitudes] = 0, 1, 0, 0, 0, 0
; expect: [nothing] = 9.0, 9.0, 9.0, 9.0, 9.0, 9.0
; expect: [nowhere] = 0, 0, 0, 0, 0, 0

        overlap SCHNEV
; expect: [chain] = 0, 1, 0, 1.0

        EXIT
; expect-flags: X'0000 0000 0000 0000'
