; lattice.s - points of a shifted rank-1 lattice, in both forms.
;
; A point has up to six coordinates, each in (0, 1). Coordinate j of point i of
; N = 2^m points, m = 0 .. 20, with shift number k of a seed, is
;
;   y = (i z_j 2^(47-m) + shift_kj) mod 2^47
;   u = y 2^-47
;
; z is the generating vector. The shifts are numbers t of the random stream with
; the lowest bit set. Therefore y is odd, u is the middle of one of 2^46 cells,
; and its mean over all shifts is exactly 1/2. Shift k of the seed s takes six
; positions of the stream before the seed's ray 0:
;
;   p = s G - 7 (k + 1) + j + 1.
;
; Different shifts are independent, so the spread of the estimates over some
; shifts gives the error of an estimate by N points.
;
; Source of z: R. Cools, F. Y. Kuo, D. Nuyens, "Constructing embedded lattice
; rules for multivariate integration" (2006), their file of 3,600 dimensions for
; 2^10 to 2^20 points. Source of random shifts: R. Cranley, T. N. L. Patterson
; (1976).

        .ifndef lattice_registers

        .include "points/stream.s"

        .equ    LATTICE_DIMENSIONS, 6

        .data
lattice_vector:
        .word   1, 182667, 469891, 498753, 110745, 446247
        .code

; Registers of the lattice, from first on: z 2^(47-m), the shifts, 2^47 - 1.
        .macro  lattice_registers first
        .regs   \first, lattice_z0, lattice_z1, lattice_z2, lattice_z3, lattice_z4, lattice_z5, lattice_shift0, lattice_shift1, lattice_shift2, lattice_shift3, lattice_shift4, lattice_shift5, lattice_mask
        .endm

; Loads all of them for N = 2^m points and the shift k of a seed. work0 .. work5
; are scratch.
        .macro  lattice_load m, seed, k, work
        EX      lattice_mask, X'7FFF FFFF FFFF'
        ES      \work\()0, 47
        SUBX    \work\()0, \m, \work\()0
        SHIFT   stream_one, \work\()0, \work\()1
        load_words lattice_vector, LATTICE_DIMENSIONS, lattice_z0, \work\()0
        .rept   LATTICE_DIMENSIONS
        MPYL    lattice_z\+, \work\()1, lattice_z\+
        .endr
        ADDX    \k, stream_one, \work\()0
        stream_state \seed, \work\()0, -7, \work\()1, \work\()2, \work\()3, \work\()4
        .rept   LATTICE_DIMENSIONS
        MPYL    \work\()1, stream_ahead0, \work\()1
        RTOR    \work\()1, lattice_shift\+
        .endr
        stream_mixed LATTICE_DIMENSIONS, lattice_shift\+, lattice_shift\+, \work\()\+
        .rept   LATTICE_DIMENSIONS
        OR      lattice_shift\+, stream_one, lattice_shift\+
        .endr
        .endm

; Sets word\+ to the first `count` coordinates y of point i, an integer.
        .macro  lattice_words i, count, word
        .rept   \count
        MPYL    lattice_z\+, \i, \word
        .endr
        .rept   \count
        ADDX    \word, lattice_shift\+, \word
        .endr
        .rept   \count
        AND     \word, lattice_mask, \word
        .endr
        .endm

; [words] := y of one coordinate, 0 .. 5, of the points with the numbers [i],
; which are integers in any order.
        .macro  lattice_coordinate i, coordinate, words
        LINKV
        MPYLV   [\i], lattice_z\coordinate, [\words]
        ADDXV   [\words], lattice_shift\coordinate, [\words]
        ANDV    [\words], lattice_mask, [\words]
        .endm

        .endif
