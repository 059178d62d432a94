; saxpy_linked.s - y := a x + y as one stream.
;
; LINKV passes each product directly to the addition. There is one start-up of
; 84 clocks, and no product is stored. x and y use the two read paths of
; memory, and the scale is broadcast.

        .include "saxpy_data.inc"

        .regs   r10, xs, ys, scale, link

        EX      xs, a
        LOD     [xs], scale
        descriptor xs, x, n
        descriptor ys, y, n
        descriptor link, y, n           ; only its length is used

        .kernel saxpy
        LINKV
        MPYSV   [xs], scale, [link]
        ADDNV   [link], [ys], [ys]
        .endkernel

        EXIT
; expect: [y] = 1.0, 3.0, 5.0, 7.0
; expect: [y + 99*64] = 199.0

; The first access to the page of the data takes 1,030 clocks, the load of the
; scale 16, and the pair 84 + 50. The exit hides under the stream:
; expect-clocks: 1180
; expect-model: cyber205-2pipe-prior
; This model has round constants; the constants of fitted models are not round.
