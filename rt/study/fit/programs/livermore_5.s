; livermore_5.s - Livermore kernel 5: tri-diagonal elimination below the
; diagonal.
;
;             DO 5 I = 2, N
;           5 X(I) = Z(I) * (Y(I) - X(I-1))

        .equ    N, 1001
        .equ    FLOPS, 2 * (N - 1)
        .include "livermore.inc"

; The words after the last operands are loaded ahead and not used.
        .data
x:              .space N
y:              .space N + 1
z:              .space N + 1
        .code

        .regs   r24, x_at, y_at, z_at, x_k, y_k, z_k

        series  x, N, 0.0, 0.0
        series  y, N, -1.0, 0.0
        series  z, N, -1.0, 0.0
        .kernel loop
        load_common common_n, n
        ES      minus, -1
        EX      x_at, x
        LOD     [x_at], x_k
        EX      y_at, y + 64
        LOD     [y_at], y_k
        EX      z_at, z + 64
        LOD     [z_at], z_k
        ADDX    n, minus, left
        IBXLE   left, r0, r0, done
next:   SUBN    y_k, x_k, x_k
        IX      y_at, 64
        LOD     [y_at], y_k
        IX      x_at, 64
        MPYS    z_k, x_k, x_k
        IX      z_at, 64
        LOD     [z_at], z_k
        STO     [x_at], x_k
        LOD     [x_at], x_k
        IBXNE   left, minus, r0, next, left
done:
        .endkernel
        EXIT
; expect: [x + 64] = 1.0                ; x(i) = 1 + x(i-1)
; expect: [x + 64 * 1000] = 1000.0
