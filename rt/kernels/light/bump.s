; bump.s - normals that a pattern changes, as both forms of the program have them
; (BUMPS = 1).
;
; A pattern (pattern.s) has a height at each point Q of its space: its value, or of a
; list of colours the number of the colour, or what a map of heights makes of that.
; Of such a map, between two entries with heights h, k and slopes s, t,
;
;   h + s u - (2 s + t + 3 (h - k)) u^2 + (s + t + 2 (h - k)) u^3,  u from 0 to 1;
;
; before the first it is the first one's height, behind the last the last one's.
;
; The corners of a tetrahedron are
;
;   c0 = (r, -1/3, 0),  c1, c2 = (-r/2, -1/3, +- sqrt(2/3)),  c3 = (0, 1, 0)
;
; with r = sqrt(8) / 3.  With X = M Q the point in the world, Q = L X, and N the
; normal there, turned against the ray,
;
;   N' = M^T N, of length one
;   N' = N' + push (height(Q + a c0) c0 + .. + height(Q + a c3) c3)
;   N  = L^T N', of length one
;
; a = accuracy, push = -5 amount 0.02 / a.  Unscaled, N' keeps its length.
;
; Quilted, with V = Q less its floor, less 1/2 in each direction, and t = |V|,
;
;   N' = N' + amount (t^3 + 3 c0 t (1 - t)^2 + 3 c1 t^2 (1 - t)) 2 / sqrt(3) V
;
; c0 and c1 = control0 and control1; as BUMP_CORNERS has it, a polynomial of t.
;
; Of a map of bumps with values at v0, v1 .., in the space of a pattern whose value is
; v there, the normals N_i in that space are (1 - u) N_i + u N_i+1, u from 0 to 1
; from v_i to v_i+1; of an average their sum by their weights.  L^T of that space,
; of length one, is the normal in the world.
;
; What comes of the new normal (spawn_vector.s, spawn_scalar.s): the ray may see its
; back.  Then a refracted ray bends the other way.  A reflected ray that would go
; behind the surface is reflected by the old normal instead, if it is behind the
; new one, too; if not, it is reflected by the old one again.  Which side of the
; surface is seen is a matter of the old one.
; Source: POV-Ray 3.7's normal, as its documentation has it, measured by its pictures.

        .record HEIGHT                  ; of a map: behind the last one beyond big
        .field  HEIGHT_AT
        .field  HEIGHT_SLOPE            ; 1 / how far the next one is
        .field  HEIGHT_TERMS, 4         ; of u^0 .. u^3
        .endrecord

        .record BUMP
        .field  BUMP_MAP, MAP_SIZE      ; a MAP without stops; function 0: of an
                                        ; average, or quilted
        .field  BUMP_HEIGHTS            ; address of the first HEIGHT, which is
                                        ; before the first value, or 0
        .field  BUMP_TO_LOCAL, 12       ; from the world, as the function wants it
        .field  BUMP_CARRY, 9           ; M^T, rows
        .field  BUMP_BACK, 9            ; L^T, of an entry from the space of its map
        .field  BUMP_SCALED             ; 1: N' gets length one, N does
        .field  BUMP_NORMALISED
        .field  BUMP_CORNERS, 24        ; of each corner a c, as the function wants
                                        ; it, and push c; quilted: factors of t,
                                        ; t^2, t^3
        .field  BUMP_FROM               ; of an entry: where it is the upper one,
        .field  BUMP_TO                 ; from there on the lower one,
        .field  BUMP_LOW                ; its value, 1 / how far the next one is;
        .field  BUMP_RISE               ; of an average its weight
        .field  BUMP_ENTRIES            ; of a map: address of the first, or 0,
        .field  BUMP_ENTRY_COUNT        ; and how many
        .endrecord
        .equ    BUMP_FUNCTION, BUMP_MAP + MAP_FUNCTION
        .equ    BUMP_WAVE, BUMP_MAP + MAP_WAVE
        .equ    BUMP_NUMBERS, BUMP_MAP + MAP_NUMBERS
        .equ    BUMP_CORNER_SIZE, 6
