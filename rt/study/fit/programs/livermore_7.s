; livermore_7.s - Livermore kernel 7: equation of state fragment.
;
;             DO 7 K = 1, N
;           7 X(K) = U(K) + R * (Z(K) + R * Y(K)) +
;            *       T * (U(K+3) + R * (U(K+2) + R * U(K+1)) +
;            *       T * (U(K+6) + Q * (U(K+5) + Q * U(K+4))))
;
; The loop compiles to eight linked pairs.

        .equ    N, 995
        .equ    FLOPS, 16 * N
        .include "livermore.inc"

        .data
common_q:       .word 3.0
common_r:       .word 2.0
common_t:       .word 4.0
x:              .space N
y:              .space N
z:              .space N
u:              .space N + 6
work:           .space N
sum:            .space N
        .code

; u0_v .. u6_v: U(K) .. U(K+6); work_v and sum_v: temporaries of the compiler.
        .regs   r24, x_v, y_v, z_v, u0_v, u1_v, u2_v, u3_v, u4_v, u5_v, u6_v
        .regs   r34, work_v, sum_v

; result := vector scalar + other
        .macro  linked_triad vector, scalar, other, result
        LINKV
        MPYSV   [\vector], \scalar, [link]
        ADDNV   [link], [\other], [\result]
        .endm

        series  y, N, 1.0, 1.0
        series  z, N, 1.0, 1.0
        series  u, N + 6, 1.0, 1.0
        .kernel loop
        load_common common_n, n
        load_common common_q, q
        load_common common_r, r
        load_common common_t, t
        EX      y_v, y
        EX      z_v, z
        EX      u0_v, u
        EX      work_v, work
        IBXLE   n, r0, r0, done
        ADDLEN  y_v, n, y_v
        ADDLEN  z_v, n, z_v
        ADDLEN  work_v, n, work_v
        RTOR    work_v, link
        linked_triad y_v, r, z_v, work_v
        elements sum_v, sum
        ADDLEN  u0_v, n, u0_v
        linked_triad work_v, r, u0_v, sum_v
        elements u1_v, u + 64
        elements u2_v, u + 64 * 2
        linked_triad u1_v, r, u2_v, work_v
        elements x_v, x
        elements u3_v, u + 64 * 3
        linked_triad work_v, r, u3_v, x_v
        elements u4_v, u + 64 * 4
        elements u5_v, u + 64 * 5
        linked_triad u4_v, q, u5_v, work_v
        elements u6_v, u + 64 * 6
        linked_triad work_v, q, u6_v, work_v
        linked_triad work_v, t, x_v, work_v
        linked_triad work_v, t, sum_v, x_v
done:
        .endkernel
        EXIT
; expect: [x] = 1199.0                  ; 243 k + 956
; expect: [x + 64 * 994] = 242741.0
