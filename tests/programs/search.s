; For each element of a vector, the index of the first element of another vector with a
; given relation to it is compared with the index counted by hand, for every use.  A
; wrong relation, reading order or count makes a word differ.
; tests: SCHEQV SCHNEV SCHGEV SCHLTV
; warns: zero-length SCHEQV SCHNEV SCHGEV SCHLTV

        .include "search.inc"

; SCHEQV: C(i) := first index j where A(i) = B(j), or the length of B if there
; is none
        uses    SCHEQV, 3, 0, 1, 2, 5, 5, 2
; expect: [SCHEQV.offset_sources] = 3, 3, 0, 3, 3, 0
; expect: [SCHEQV.short_source] = 3, 0, 1, 2, 2, 2
; expect: [SCHEQV.negated] = 5, 5, 5, 2, 5, 5
; expect: [SCHEQV.magnitudes] = 3, 0, 1, 2, 5, 5
; expect: [SCHEQV.chain] = 1, 2, 0, 1.0
; SCHNEV: C(i) := first index j where A(i) is not equal to B(j), or the length
; of B if there is none
        uses    SCHNEV, 0, 1, 0, 0, 0, 0, 0
; expect: [SCHNEV.offset_sources] = 0, 0, 1, 0, 0, 1
; expect: [SCHNEV.short_source] = 0, 1, 0, 0, 0, 0
; expect: [SCHNEV.negated] = 0, 0, 0, 0, 0, 0
; expect: [SCHNEV.magnitudes] = 0, 1, 0, 0, 0, 0
; expect: [SCHNEV.chain] = 0, 1, 0, 1.0
; SCHGEV: C(i) := first index j where A(i) >= B(j), or the length of B if
; there is none
        uses    SCHGEV, 0, 0, 0, 0, 5, 0, 0
; expect: [SCHGEV.offset_sources] = 3, 0, 0, 3, 0, 0
; expect: [SCHGEV.short_source] = 0, 0, 0, 0, 0, 0
; expect: [SCHGEV.negated] = 0, 0, 5, 0, 5, 5
; expect: [SCHGEV.magnitudes] = 2, 0, 0, 2, 5, 0
; expect: [SCHGEV.chain] = 0, 0, 0, 1.0
; SCHLTV: C(i) := first index j where A(i) < B(j), or the length of B if
; there is none
        uses    SCHLTV, 1, 1, 5, 1, 5, 5, 1
; expect: [SCHLTV.offset_sources] = 0, 3, 1, 3, 3, 1
; expect: [SCHLTV.short_source] = 1, 1, 5, 1, 1, 1
; expect: [SCHLTV.negated] = 1, 1, 0, 1, 5, 0
; expect: [SCHLTV.magnitudes] = 0, 1, 5, 0, 5, 5
; expect: [SCHLTV.chain] = 4, 0, 0, 1.0
        EXIT
