; generate_vector.s - the queue's rays.
;
; Pixel k of the frame lies in row floor(k / width) and column
; k - width row; its ray is  base + column per_column + row per_row  (see
; camera.s), brought to length one.  k / width is cut towards zero, never up,
; so that its floor is the row for every k.
;
; In:  pixel (the first k, an integer), n; view.
; Out: wox woy woz wdx wdy wdz.
; Source: camera.s for the formula; derived here for vectors of any length.

        .macro  direction base, col, row, d
        LINKV
        MPYSV   [w0], \col, [w2]
        ADDNV   [w2], \base, [w2]
        LINKV
        MPYSV   [w1], \row, [w3]
        ADDNV   [w3], [w2], [\d]
        .endm

        .kernel generate
generate:
        INTVLV  pixel, one_index, [w0]
        ADDNV   [w0], r0, [w0]
        DIVSV   [w0], width, [w1]
        FLRV    [w1], [w1]
        ADDNV   [w1], r0, [w1]
        MPYSV   [w1], width, [w2]
        SUBNV   [w0], [w2], [w0]
        direction basex, colx, rowx, wdx
        direction basey, coly, rowy, wdy
        direction basez, colz, rowz, wdz
        normalise wdx, wdy, wdz, w2, w3
        VTOV    viewlx, [wox]
        VTOV    viewly, [woy]
        VTOV    viewlz, [woz]
        BIM     0, link
        .endkernel
