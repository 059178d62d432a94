; livermore_1.s - Livermore kernel 1: hydro fragment.
;
;             DO 1 K = 1, N
;           1 X(K) = Q + Y(K) * (R * Z(K+10) + T * Z(K+11))
;
; The loop compiles to one multiplication and two linked pairs.

        .equ    N, 1001
        .equ    FLOPS, 5 * N
        .include "livermore.inc"

        .data
common_q:       .word 1.0
common_r:       .word 2.0
common_t:       .word -1.0
x:              .space N
y:              .space N
z:              .space N + 11
work:           .space N
        .code

        .regs   r24, x_v, y_v, z10_v, z11_v, work_v

        series  y, N, 1.0, 1.0
        series  z, N + 11, 1.0, 1.0
        .kernel loop
        load_common common_n, n
        load_common common_q, q
        load_common common_r, r
        load_common common_t, t
        EX      x_v, x
        EX      y_v, y
        EX      z10_v, z + 64 * 10
        EX      z11_v, z + 64 * 11
        EX      work_v, work
        IBXLE   n, r0, r0, done
        ADDLEN  z11_v, n, z11_v
        ADDLEN  work_v, n, work_v
        MPYSV   [z11_v], t, [work_v]
        ADDLEN  z10_v, n, z10_v
        RTOR    work_v, link
        LINKV
        MPYSV   [z10_v], r, [link]
        ADDNV   [link], [work_v], [work_v]
        ADDLEN  x_v, n, x_v
        ADDLEN  y_v, n, y_v
        LINKV
        MPYSV   [y_v], [work_v], [link]
        ADDNV   [link], q, [x_v]
done:
        .endkernel
        EXIT
; expect: [x] = 11.0                    ; 1 + k (k + 9)
; expect: [x + 64 * 1000] = 1011011.0
