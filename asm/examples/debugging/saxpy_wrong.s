; saxpy_wrong.s - y := a x + y as in ../saxpy_scalar.s, with a mistake.
; docs/debugging.md shows how to find it.

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
        STO     [ys, one], sum
        IBXLT   index, one, count, loop, index
        .endkernel

        EXIT
; expect: [y] = 1.0, 3.0, 5.0, 7.0
