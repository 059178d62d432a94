; once.s - the roots of many quartics in 0 .. 1 by regula falsi, with the Illinois rule:
; compressed once, when half of the roots are found.
;
;   f(s) = k4 s^4 + k3 s^3 + k2 s^2 + k1 s + k0
;
; A and B are the ends of a bracket at which the signs of f differ, B the newer one.
;
;   x = B - (B - A) f(B) / (f(B) - f(A)),  but no nearer to B than 7/8 CLOSE
;
; If the sign has changed from B to x, A := B, else f(A) is halved.  B := x.  The root is found
; when |B - A| <= CLOSE.  Sign of 0: +.

        .include "core.s"

        .ifndef n
        .equ    n, 20                   ; quartics
        .endif
        .equ    CLOSE, 1e-10

        .data
k0:     .rept   n                       ; s^4 + s - c, c = 1/n, 2/n ..
        .word   -1.0 * (1 + \+) / n
        .endr
k1:     .rept   n
        .word   1.0
        .endr
k2:     .rept   n
        .word   0.0
        .endr
k3:     .rept   n
        .word   0.0
        .endr
k4:     .rept   n
        .word   1.0
        .endr
root:   .space  n

as:     .space  n
fas:    .space  n
bs:     .space  n
fbs:    .space  n
xs:     .space  n
fxs:    .space  n
ws:     .space  n
steps:  .space  n
places: .space  n
        .bitvector b_signs, n
        .bitvector x_signs, n
        .bitvector change_bits, n
        .bitvector active_bits, n
        .bitvector done_bits, n
        .bitvector some_bits, n
        .code

        .regs   r10, count, left, found, t, one, roots
        .regs   r20, c0, c1, c2, c3, c4, a, fa, b, fb, x, fx, w, s, at
        .regs   r40, b_sign, x_sign, change, active, done, some
        .regs   r50, close, least, half, unity

        .macro  vector name, address
        EX      \name, \address
        ADDLEN  \name, count, \name
        .endm

; Give a vector the length of the loop; its address stays.
        .macro  lengthen vector
        ELEN    \vector, 0
        ADDLEN  \vector, count, \vector
        .endm

        .macro  exchange first, second
        RTOR    \first, t
        RTOR    \second, \first
        RTOR    t, \second
        .endm

; [y] := f of [v].
        .macro  value v, y
        MPYSV   [c4], [\v], [\y]
        ADDNV   [\y], [c3], [\y]
        MPYSV   [\y], [\v], [\y]
        ADDNV   [\y], [c2], [\y]
        MPYSV   [\y], [\v], [\y]
        ADDNV   [\y], [c1], [\y]
        MPYSV   [\y], [\v], [\y]
        ADDNV   [\y], [c0], [\y]
        .endm

        EX      count, n
        vector  c0, k0
        vector  c1, k1
        vector  c2, k2
        vector  c3, k3
        vector  c4, k4
        vector  a, as
        vector  fa, fas
        vector  b, bs
        vector  fb, fbs
        vector  x, xs
        vector  fx, fxs
        vector  w, ws
        vector  s, steps
        vector  at, places
        vector  b_sign, b_signs
        vector  x_sign, x_signs
        vector  change, change_bits
        vector  active, active_bits
        vector  done, done_bits
        vector  some, some_bits
        EX      roots, root
        load_constant close, CLOSE
        load_constant least, 0.875 * CLOSE
        load_constant half, 0.5
        load_constant unity, 1.0
        ES      one, 1
        RTOR    count, left

        .kernel begin
        INTVLV  r0, one, [at]
        VTOV    r0, [a]
        VTOV    [c0], [fa]
        VTOV    unity, [b]
        value   b, fb
        CMPGEV  [fb], r0, [b_sign]
        EQVB    [b_sign], [b_sign], [active]
        VTOV    unity, [w]
        .endkernel

        .kernel falsi
step:   SUBNV   [fb], [fa], [s]
        DIVSV   [fb], [s], [s]
        MPYSV   [w], [s], [s]
        CMPLTV  |[s]|, least, [some]
        CNTOB   [some], found
        IBXEQ   found, r0, r0, long_enough
        VTOV    least, [s] ? [some]
        CMPLTV  [w], r0, [change]
        ANDB    [some], [change], [some]
        VTOV    -[s], [s] ? [some]
long_enough:
        SUBNV   [b], [s], [x]
        value   x, fx
        CMPGEV  [fx], r0, [x_sign]
        XORB    [x_sign], [b_sign], [change]
        MPYSV   [fa], half, [fa] ?! [change]
        VTOV    [b], [a] ? [change]
        VTOV    [fb], [fa] ? [change]
        exchange b, x
        exchange fb, fx
        exchange b_sign, x_sign
        SUBNV   [b], [a], [w]
        CMPGEV  close, |[w]|, [done]
        ANDB    [done], [active], [done]
        CNTOB   [done], found
        IBXEQ   found, r0, r0, again

        CPSV    [b], [x] ? [done]
        CPSV    [at], [s] ? [done]
        VTOVX   [s], [x], [roots]
        SUBX    left, found, left
        IBXEQ   left, r0, r0, end
        ANDNB   [active], [done], [active]
        EX      t, n
        IBXNE   t, r0, count, again
        ADDX    left, left, t
        IBXGE   t, r0, count, again
        .endkernel

        .kernel compress
        CPSV    [c0], [c0] ? [active]
        CPSV    [c1], [c1] ? [active]
        CPSV    [c2], [c2] ? [active]
        CPSV    [c3], [c3] ? [active]
        CPSV    [c4], [c4] ? [active]
        CPSV    [a], [a] ? [active]
        CPSV    [fa], [fa] ? [active]
        CPSV    [b], [b] ? [active]
        CPSV    [fb], [fb] ? [active]
        CPSV    [w], [w] ? [active]
        CPSV    [at], [at] ? [active]
        CPSB    [b_sign], [b_sign] ? [active]
        RTOR    left, count
        lengthen fx
        lengthen x_sign
        lengthen change
        lengthen active
        lengthen done
        lengthen some
        EQVB    [active], [active], [active]
        .endkernel

        .kernel falsi
again:  lengthen x
        lengthen s
        BIM     step
        .endkernel

end:    EXIT
