; pattern.s - the waves and series of patterns, for the scalar and the vector
; form (PATTERNS = 1).
;
; A pattern has a value v at each point X of the pigment's space.  v is a
; position between the stops of a map.  rt/scene/patterns.def has the formulas;
; in that of a gradient, x is along its axis, and the floor is at least 0.  The
; value of a list is the index of its colour divided by that of the last one.
; All other values are then transformed by a wave:
;
;   w = frequency v + phase, reduced modulo 1.00001 towards 0; or v, if the
;       frequency is 0; w - floor(w) if that is below 0
;   ramp w,  triangle 2 w up to 1/2, then 2 - 2 w,  sine (1 + sin(2 pi w)) / 2,
;   scallop |sin(pi w)|,  cubic (3 - 2 w) w^2,  poly w^exponent
;
; Bricks: x, y, z are increased by the mortar m and k_checker.  With the brick's
; size (w, h, d) and {u} = u - floor(u) there is mortar where
;
;   {y/h} <= m/h,   {x/w + s} <= m/w,   {z/d + 1/2 - s} <= m/d
;
; with s = 0 if {y/(2 h)} <= 1/2, else 1/2.
;
; Hexagons: the nearest node of the lattice k = 2/3 x, a = z / sqrt(3) - x/3 is
; found by three roundings (k, a, -k-a; the one that changes most is computed
; from the other two).  The value is a - k modulo 3, halved.
;
; sin(2 pi t): t minus the nearest integer, reflected at 1/4 if it is beyond,
; and the series up to the 15th power, within 1e-11.  Angles: atan by its series
; up to the 17th power below tan(pi/8), within 3e-9; above, of
; (t - 1) / (t + 1).
; Source: POV-Ray 3.7's patterns and waves, by its documentation, verified by
; its pictures (1.00001 is from these); the nearest hexagon by cube coordinates.

        .record MAP
        .field  MAP_FUNCTION            ; address of the routine that computes v
        .field  MAP_WAVE                ; address of the one that computes w;
                                        ; 0: v is the value
        .field  MAP_NUMBERS, 4          ; frequency, phase, exponent; for bricks
                                        ; 1 / size (3 words), mortar
        .field  MAP_STOPS               ; as P_STOPS
        .field  MAP_STOP_COUNT
        .endrecord
        .equ    P_MAP_FUNCTION, P_MAP + MAP_FUNCTION
        .equ    P_MAP_WAVE, P_MAP + MAP_WAVE
        .equ    P_MAP_NUMBERS, P_MAP + MAP_NUMBERS
        .equ    P_MAP_STOPS, P_MAP + MAP_STOPS
        .equ    P_MAP_STOP_COUNT, P_MAP + MAP_STOP_COUNT

        .data
pattern_constants:
        .word 6.28318530717958647693    ; 2 pi
        .word 0.15915494309189533577    ; 1 / (2 pi)
        .word 7.64716373181981647590e-13 ; 1/15!
        .word 0.25
        .word 0.41421356237309504880    ; tan(pi/8)
        .word 1.00001, 0.99999000009999900001   ; 1.00001 and its reciprocal
        .word 0.66666666666666666667    ; 2/3
        .word 0.57735026918962576451    ; 1/sqrt(3)
        .word 0.33333333333333333333
        .word 3.0
        .equ    PATTERN_CONSTANTS, 11
        .code
