; saxpy_linked.s - y := a x + y as one stream.
;
; LINKV passes each product directly to the addition: there is one start-up of
; 84 clocks, and no product is stored. x and y use the two read paths of the
; memory; the scale is broadcast.

        .include "saxpy_data.inc"

        .regs   r10, xs, ys, scale, link

        EX      xs, a
        LOD     [xs], scale
        descriptor xs, x, n
        descriptor ys, y, n
        descriptor link, y, n           ; never stored; only its length counts

        .kernel saxpy
        LINKV
        MPYSV   [xs], scale, [link]
        ADDNV   [link], [ys], [ys]
        .endkernel

        EXIT
; expect: [y] = 1.0, 3.0, 5.0, 7.0
; expect: [y + 99*64] = 199.0

; 1,030 clocks for the first touch of the data's page, 16 until the scale is
; loaded, 84 + 50; the exit is hidden under the stream:
; expect-clocks: 1180
; expect-model: cyber205-2pipe-prior
; (its constants are round numbers, the fitted ones are not)
