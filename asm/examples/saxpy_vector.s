; saxpy_vector.s - y := a x + y with vector instructions.
;
; The product is stored in memory and loaded again. Both instructions have a
; start-up of 51 clocks and take half a clock per element on two pipes. The first
; 10 clocks of the second start-up overlap the first stream.

        .include "saxpy_data.inc"

        .regs   r10, xs, ys, ts, scale

        .data
t:      .space  n
        .code

        EX      xs, a
        LOD     [xs], scale
        descriptor xs, x, n
        descriptor ys, y, n
        descriptor ts, t, n

        .kernel saxpy
        MPYSV   [xs], scale, [ts]
        ADDNV   [ts], [ys], [ys]
        .endkernel

        EXIT
; expect: [y] = 1.0, 3.0, 5.0, 7.0
; expect: [y + 99*64] = 199.0

; The first access to the page of the data takes 1,030 clocks, the load of the
; scale 16, and the vectors 101 + 101 - 10. The exit hides under the stream:
; expect-clocks: 1238
; expect-model: cyber205-2pipe-prior
; This model has round constants; the constants of fitted models are not round.
