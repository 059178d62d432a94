; saxpy_linked.s - y := a x + y as one stream.
;
; LINKV hands each product straight to the addition: one start-up of 84
; clocks, and nothing of the product is stored.  The memory has two read paths,
; which x and y take; the scale is broadcast.

        .include "saxpy_data.inc"

        .regs   r10, xs, ys, scale, link

        EX      xs, a
        LOD     [xs], scale
        descriptor xs, x, n
        descriptor ys, y, n
        descriptor link, y, n           ; only a name, as long as the result

        .kernel saxpy
        LINKV
        MPYSV   [xs], scale, [link]
        ADDNV   [link], [ys], [ys]
        .endkernel

        EXIT
; expect: [y] = 1.0, 3.0, 5.0, 7.0
; expect: [y + 99*64] = 199.0

; 1,030 clocks for the first touch of the data's page, 16 until the scale is
; loaded, 84 + 50, the exit hidden beneath:
; expect-clocks: 1180
; expect-model: cyber205-2pipe-prior
; (its constants are round, the fitted ones are not)
