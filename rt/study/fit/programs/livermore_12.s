; livermore_12.s - Livermore kernel 12: first difference.
;
;             DO 12 K = 1, N
;          12 X(K) = Y(K+1) - Y(K)
;
; The loop compiles to one subtraction.

        .equ    N, 1000
        .equ    FLOPS, N
        .include "livermore.inc"

        .data
x:              .space N
y:              .space N + 1
        .code

        .regs   r24, x_v, y_v, y1_v

        series  y, N + 1, 1.0, 3.0
        .kernel loop
        load_common common_n, n
        EX      x_v, x
        EX      y_v, y
        EX      y1_v, y + 64
        IBXLE   n, r0, r0, done
        ADDLEN  y1_v, n, y1_v
        ADDLEN  y_v, n, y_v
        ADDLEN  x_v, n, x_v
        SUBNV   [y1_v], [y_v], [x_v]
done:
        .endkernel
        EXIT
; expect: [x] = 3.0, 3.0
; expect: [x + 64 * 999] = 3.0
