; saxpy_scalar.s - computes y := a x + y, one element after the other.
;
; Both addresses are in registers, and the loop increments the index. An
; iteration waits for its loads (15 clocks), the product and the sum (5 each),
; and the branch (8). It takes 35 clocks for two flops, which is 2.9 Mflop/s.

        .include "saxpy_data.inc"

        .regs   r10, xs, ys, scale, index, count, one
        .regs   r20, left, right, product, sum

        EX      xs, a
        LOD     [xs], scale
        EX      xs, x
        EX      ys, y
        ES      index, 0
        ES      count, n
        ES      one, 1

        .kernel saxpy
loop:   LOD     [xs, index], left
        LOD     [ys, index], right
        MPYS    left, scale, product
        ADDN    product, right, sum
        STO     [ys, index], sum
        IBXLT   index, one, count, loop, index
        .endkernel

        EXIT
; expect: [y] = 1.0, 3.0, 5.0, 7.0
; expect: [y + 99*64] = 199.0

; The first access to the page of the data takes 1,030 clocks, the instructions
; before the loop 7, 99 iterations 35 each, the last iteration and the exit 28:
; expect-clocks: 4530
; expect-model: cyber205-2pipe-prior
; This model has round constants; the constants of fitted models are not round.
