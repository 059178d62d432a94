; lattice_vector.s - points of a shifted rank-1 lattice, a queue at a time.
;
; Formulas: lattice_scalar.s. The numbers of the points are a vector of
; integers, in any order.

        .ifndef lattice_coordinate

        .include "points/lattice_scalar.s"
        .include "points/stream_vector.s"

; [words] := y of one coordinate, 0 .. 5, of the points with the numbers [i].
        .macro  lattice_coordinate i, coordinate, words
        LINKV
        MPYLV   [\i], lattice_z\coordinate, [\words]
        ADDXV   [\words], lattice_shift\coordinate, [\words]
        ANDV    [\words], lattice_mask, [\words]
        .endm

        .endif
