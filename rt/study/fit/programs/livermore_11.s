; livermore_11.s - Livermore kernel 11: first sum.
;
;             X(1) = Y(1)
;             DO 11 K = 2, N
;          11 X(K) = X(K-1) + Y(K)

        .equ    N, 1001
        .equ    FLOPS, N - 1
        .include "livermore.inc"

; The word after the last Y is loaded ahead and not used.
        .data
x:              .space N
y:              .space N + 1
        .code

        .regs   r24, x_at, y_at, x_k, y_k

        series  x, N, 0.0, 0.0
        series  y, N, 1.0, 0.0
        .kernel loop
        load_common common_n, n
        ES      minus, -1
        EX      y_at, y
        LOD     [y_at], x_k
        EX      x_at, x
        STO     [x_at], x_k
        LOD     [x_at], x_k
        IX      y_at, 64
        LOD     [y_at], y_k
        ADDX    n, minus, left
        IBXLE   left, r0, r0, done
next:   ADDN    x_k, y_k, x_k
        IX      y_at, 64
        LOD     [y_at], y_k
        IX      x_at, 64
        STO     [x_at], x_k
        LOD     [x_at], x_k
        IBXNE   left, minus, r0, next, left
done:
        .endkernel
        EXIT
; expect: [x] = 1.0, 2.0
; expect: [x + 64 * 1000] = 1001.0
