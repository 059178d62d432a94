; livermore_3.s - Livermore kernel 3: inner product.
;
;             Q = 0.
;             DO 3 K = 1, N
;           3 Q = Q + Z(K) * X(K)
;
; The loop compiles to one dot product, whose sum is added to Q.

        .equ    N, 1001
        .equ    FLOPS, 2 * N
        .include "livermore.inc"

        .data
common_q:       .word 1.0
x:              .space N
z:              .space N
        .code

        .regs   r24, sum, sum_lower, x_v, z_v, q_at

        series  x, N, 1.0, 0.0
        series  z, N, 1.0, 1.0
        .kernel loop
        load_common common_n, n
        EX      q_at, common_q
        STO     [q_at], r0
        EX      x_v, x
        EX      z_v, z
        IBXLE   n, r0, r0, done
        ADDLEN  x_v, n, x_v
        ADDLEN  z_v, n, z_v
        DOTV    [z_v], [x_v], sum
        ADDN    sum, r0, sum            ; adds the two parts of the sum
        ADDN    sum, sum_lower, sum
        LOD     [q_at], q
        ADDN    q, sum, q
        STO     [q_at], q
done:
        .endkernel
        EXIT
; expect: [common_q] = 501501.0         ; n (n + 1) / 2
