; start.s - a queue of rays and a sphere: data and descriptors are complete, the formulas are missing.

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
        .regs   r30, center0, center1, center2, radius2, big, minus_big, sphere_at

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
        load_constant big, 1e30
        load_constant minus_big, -1e30

        .kernel sphere
; your code here: tin and tout of all rays.  l0, l1, l2, t, b, h and bits are room for
; intermediate results.
        .endkernel
        EXIT
