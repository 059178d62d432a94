; bump.s - the formulas and records of normals that a pattern changes, for the
; scalar and the vector form (BUMPS = 1).
;
; A pattern (pattern.s) has a height at each point Q of its space: its value,
; the index of the colour in a list of colours, or the value of a map of
; heights.  Between two entries of such a map, with heights h, k and slopes
; s, t, the height is
;
;   h + s u - (2 s + t + 3 (h - k)) u^2 + (s + t + 2 (h - k)) u^3,  0 <= u <= 1.
;
; Before the first entry the height is that of the first one, after the last
; entry that of the last one.
;
; The corners of a tetrahedron are
;
;   c0 = (r, -1/3, 0),  c1, c2 = (-r/2, -1/3, +- sqrt(2/3)),  c3 = (0, 1, 0)
;
; with r = sqrt(8) / 3.  X = M Q is the point in the world, Q = L X, and N is
; the normal there, turned against the ray:
;
;   N' = M^T N, of length one
;   N' = N' + push (height(Q + a c0) c0 + .. + height(Q + a c3) c3)
;   N  = L^T N', of length one
;
; a = accuracy, push = -5 amount 0.02 / a.  If not scaled, N' keeps its length.
;
; For quilted, with V = Q - floor(Q) - 1/2 in each coordinate, and t = |V|:
;
;   N' = N' + amount (t^3 + 3 c0 t (1 - t)^2 + 3 c1 t^2 (1 - t)) 2 / sqrt(3) V
;
; c0 and c1 = control0 and control1; BUMP_CORNERS holds this as a polynomial of
; t.
;
; A map of bumps has values v0, v1 .., in the space of a pattern with the value
; v at the point.  The normals N_i in that space give (1 - u) N_i + u N_i+1,
; with u from 0 to 1 between v_i and v_i+1; for an average they give their
; weighted sum.  The normal in the world is L^T of that, normalised.
;
; The ray may see the back of the new normal (spawn_vector.s, spawn_scalar.s).
; Then a refracted ray bends the other way.  A reflected ray that would go
; behind the surface is reflected by the old normal instead, if it is also
; behind the new one; otherwise it is reflected by the old one a second time.
; The old normal decides which side of the surface is seen.
; Source: POV-Ray 3.7's normal, by its documentation, verified by its pictures.

        .record HEIGHT                  ; of a map; the last one is beyond big
        .field  HEIGHT_AT
        .field  HEIGHT_SLOPE            ; 1 / distance to the next one
        .field  HEIGHT_TERMS, 4         ; coefficients of u^0 .. u^3
        .endrecord

        .record BUMP
        .field  BUMP_MAP, MAP_SIZE      ; a MAP without stops; function 0: an
                                        ; average, or quilted
        .field  BUMP_HEIGHTS            ; address of the first HEIGHT, which
                                        ; precedes the first value, or 0
        .field  BUMP_TO_LOCAL, 12       ; from the world to the function's space
        .field  BUMP_TRANSFORM, 9       ; M^T, by rows
        .field  BUMP_BACK, 9            ; L^T; of an entry from its map's space
        .field  BUMP_SCALED             ; 1: N' is normalised; the next: N is
        .field  BUMP_NORMALISED
        .field  BUMP_CORNERS, 24        ; per corner: a c, in the function's
                                        ; space, and push c; quilted: factors of
                                        ; t, t^2, t^3
        .field  BUMP_FROM               ; of an entry: it is the upper one from
        .field  BUMP_TO                 ; here on, and the lower one from here
        .field  BUMP_LOW                ; on; its value, 1 / distance to the
        .field  BUMP_RISE               ; next one; of an average its weight
        .field  BUMP_ENTRIES            ; of a map: address of the first, or 0;
        .field  BUMP_ENTRY_COUNT        ; their number
        .endrecord
        .equ    BUMP_FUNCTION, BUMP_MAP + MAP_FUNCTION
        .equ    BUMP_WAVE, BUMP_MAP + MAP_WAVE
        .equ    BUMP_NUMBERS, BUMP_MAP + MAP_NUMBERS
        .equ    BUMP_CORNER_SIZE, 6
