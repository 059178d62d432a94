; solution.s - the intersections of a queue of rays with a sphere.
;
; With L = C - O, D of length one:
;
;   b = L . D              distance to the closest approach to the centre
;   w = b D - L            from the centre to that point
;   h = r^2 - w . w        h < 0: the ray misses
;   tin = b - sqrt(h),  tout = b + sqrt(h)
;
; Differences are linked to their squares.  The root is computed for the hits only.

        .include "core.s"

        .ifndef n
        .equ    n, 3                    ; rays in the queue
        .endif

        .data
ox:     .rept   n                       ; O
        .word   0.0
        .endr
oy:     .rept   n
        .word   0.25 * \+
        .endr
oz:     .rept   n
        .word   0.0
        .endr
dx:     .rept   n                       ; D
        .word   0.0
        .endr
dy:     .rept   n
        .word   0.0
        .endr
dz:     .rept   n
        .word   1.0
        .endr
sphere: .word   0.0, 0.5, 4.0, 1.0      ; C and r^2
tin:    .space  n
tout:   .space  n
lx:     .space  n
ly:     .space  n
lz:     .space  n
part:   .space  n
along:  .space  n
square: .space  n
        .bitvector hits, n
        .code

        .regs   r10, o0, o1, o2, d0, d1, d2, in, out
        .regs   r20, l0, l1, l2, t, b, h, bits
        .regs   r30, center0, center1, center2, radius2, big, minus_big, sphere_at, handed, apart

        EX      sphere_at, sphere
        ELEN    sphere_at, 4
        SWAP    [sphere_at], center0, [r0]
        descriptor o0, ox, n
        descriptor o1, oy, n
        descriptor o2, oz, n
        descriptor d0, dx, n
        descriptor d1, dy, n
        descriptor d2, dz, n
        descriptor in, tin, n
        descriptor out, tout, n
        descriptor l0, lx, n
        descriptor l1, ly, n
        descriptor l2, lz, n
        descriptor t, part, n
        descriptor b, along, n
        descriptor h, square, n
        descriptor bits, hits, n
        descriptor handed, part, n      ; not stored
        load_constant big, 1e30
        load_constant minus_big, -1e30

; square := (b d - l)^2
        .macro  square_of_w d, l, square
        MPYSV   [b], [\d], [t]
        LINKV
        SUBNV   [t], [\l], [handed]
        MPYSV   [handed], [handed], [\square]
        .endm

        .kernel sphere
        SUBNV   center0, [o0], [l0]
        SUBNV   center1, [o1], [l1]
        SUBNV   center2, [o2], [l2]
        MPYSV   [l0], [d0], [b]
        MPYSV   [l1], [d1], [t]
        ADDNV   [b], [t], [b]
        MPYSV   [l2], [d2], [t]
        ADDNV   [b], [t], [b]

        square_of_w d0, l0, h
        square_of_w d1, l1, l1
        ADDNV   [h], [l1], [h]
        square_of_w d2, l2, l2
        ADDNV   [h], [l2], [h]
        SUBNV   radius2, [h], [h]

; Only the rays that hit: l0 = b, l1 = sqrt(h) and then b + sqrt(h), l2 = b - sqrt(h).
        CMPGEV  [h], r0, [bits]
        CPSV    [b], [l0] ? [bits]
        CPSV    [h], [l1] ? [bits]
        EX      apart, lz - ly
        ADDX    l1, apart, l2           ; as long as l1
        SQRTV   [l1], [l1]
        SUBNV   [l0], [l1], [l2]
        ADDNV   [l0], [l1], [l1]
        MRGV    [l2], big, [in] ? [bits]
        MRGV    [l1], minus_big, [out] ? [bits]
        .endkernel
        EXIT
