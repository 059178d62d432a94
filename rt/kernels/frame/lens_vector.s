; lens_vector.s - computes rays through a lens (lens.s), in vectors.
;
; In:  w0, w1 = columns and rows of samples; adx ady adz, not normalised;
;      aox aoy aoz of an orthographic camera.
; Out: adx ady adz, not normalised; aox aoy aoz.

        .share  scratch
        .regs   r244, lens_across, lens_table, lens_focus, lens_locx, lens_locy
        .regs   r249, lens_locz
        .endshare

; Computes the position of samples within their pixel, across or down.
        .macro  within_pixel position, into
        LINKV
        DIVSV   [\position], lens_across, [\into]
        FLRV    [\into], [\into]
        ADDNV   [\into], r0, [\into]
        MPYSV   [\into], lens_across, [\into]
        SUBNV   [\position], [\into], [\into]
        .endm

        .macro  through_lens location, o, d
        VXTOV   [w2], [lens_table], [w3]
        .if     ORTHOGRAPHIC
        ADDNV   [\o], [w3], [\o]
        .else
        ADDNV   [w3], \location, [\o]
        .endif
        LINKV
        MPYSV   [w3], lens_focus, [w3]
        SUBNV   [\d], [w3], [\d]
        .endm

        .macro  lens_rays
        load_word scene_samples, s1
        ADDN    s1, r0, lens_across
        load_word scene_lens, lens_table
        load_word view + 64 * VIEW_FOCUS, lens_focus
        within_pixel w0, w2
        within_pixel w1, w3
        LINKV
        MPYSV   [w3], lens_across, [w3]
        ADDNV   [w3], [w2], [w2]
        FLRV    [w2], [w2]
        .if     1 - ORTHOGRAPHIC
        EX      s0, view + 64 * VIEW_LOCATION
        ELEN    s0, 3
        SWAP    [s0], lens_locx, [r0]
        .endif
        MPYX    s1, s1, s1
        SHIFTI  s1, 6, s1
        through_lens lens_locx, aox, adx
        ADDX    lens_table, s1, lens_table
        through_lens lens_locy, aoy, ady
        ADDX    lens_table, s1, lens_table
        through_lens lens_locz, aoz, adz
        .endm
