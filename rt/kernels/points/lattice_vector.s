; lattice_vector.s - points of a shifted rank-1 lattice (lattice_scalar.s has the
; formulas), a queue at a time.  Numbers of points are the integers of a vector, in
; any order.

        .ifndef lattice_coordinate

        .include "points/lattice_scalar.s"
        .include "points/stream_vector.s"

; [words] := y of one of the coordinates, 0 .. 5, of the points whose numbers are
; [i].
        .macro  lattice_coordinate i, coordinate, words
        LINKV
        MPYLV   [\i], lattice_z\coordinate, [\words]
        ADDXV   [\words], lattice_shift\coordinate, [\words]
        ANDV    [\words], lattice_mask, [\words]
        .endm

        .endif
