; livermore_19.s - Livermore kernel 19: general linear recurrence.
;
;             DO 191 K = 1, N
;             B5(K) = SA(K) + STB5 * SB(K)
;         191 STB5 = B5(K) - STB5
;             DO 193 I = 1, N
;             K = N - I + 1
;             B5(K) = SA(K) + STB5 * SB(K)
;         193 STB5 = B5(K) - STB5
;
; B5(K) and STB5 are both stored and loaded again.

        .equ    N, 101
        .equ    FLOPS, 6 * N
        .include "livermore.inc"

; The words after SA and SB are loaded ahead and not used.
        .data
common_stb5:    .word 0
                .space 1
sa:             .space N + 1
                .space 1
sb:             .space N + 1
b5:             .space N
        .code

        .regs   r24, b_at, sa_at, sb_at, stb5_at, b_k, sa_k, sb_k, stb5, p

; Processes all elements from the three addresses on, in steps of step bits.
        .macro  elements_in_turn step
next\@: MPYS    stb5, sb_k, p
        IX      sb_at, \step
        LOD     [sb_at], sb_k
        ADDN    sa_k, p, b_k
        IX      sa_at, \step
        LOD     [sa_at], sa_k
        STO     [b_at], b_k
        LOD     [b_at], b_k
        IX      b_at, \step
        SUBN    b_k, stb5, stb5
        STO     [stb5_at], stb5
        LOD     [stb5_at], stb5
        IBXNE   left, minus, r0, next\@, left
        .endm

        series  sa, N, 1.0, 0.0
        series  sb, N, 2.0, 0.0
        .kernel loop
        load_common common_n, n
        EX      stb5_at, common_stb5
        LOD     [stb5_at], stb5
        ES      minus, -1
        EX      sa_at, sa
        LOD     [sa_at], sa_k
        EX      sb_at, sb
        LOD     [sb_at], sb_k
        EX      b_at, b5
        IBXLE   n, r0, r0, done
        RTOR    n, left
        elements_in_turn 64
        IX      sa_at, -64
        LOD     [sa_at], sa_k
        IX      sb_at, -64
        LOD     [sb_at], sb_k
        IX      b_at, -64
        RTOR    n, left
        elements_in_turn -64
done:
        .endkernel
        EXIT
; expect: [common_stb5] = 202.0         ; STB5 + 1 each time, B5 = 2 STB5 + 1
; expect: [b5] = 403.0
; expect: [b5 + 64 * 100] = 203.0
