; camera.s - computes the view, from which the ray of any pixel follows.
;
; It runs once per frame, on the scalar unit. The ray through the point u, v of
; the picture starts at the location. Its direction is direction + u right + v
; up, with u = (column + 1/2)/width - 1/2 and v = 1/2 - (row + 1/2)/height. This
; is linear in column and row:
;
;   per column = right / width          per row = -(up / height)
;   base = direction + (1/2 per column - 1/2 right)
;                    + (1/2 per row + 1/2 up)
;
; The rays of an orthographic camera (ORTHOGRAPHIC = 1) start at location + u
; right + v up and have one direction. Here location takes the place of
; direction above, and the direction, of length one, that of location.
;
; A camera with a lens (LENS = 1, lens.s) that is focused at distance F also has
; focus = |direction| / F, or 1 / F if it is orthographic.
;
; In: scene_camera, scene_width, scene_height.  Out: view.
; Source: POV-Ray's cameras. The perspective camera is common to all tracers.
;
; The main program calls it once, while its registers are free.

        .share                          ; runs once, before they are used
        .regs   r32, cam_at, view_at, size_at
        .regs   r36, cam_locx, cam_locy, cam_locz, cam_dirx, cam_diry
        .regs   r41, cam_dirz, cam_rightx, cam_righty, cam_rightz, cam_upx
        .regs   r46, cam_upy, cam_upz
        .regs   r48, cam_width, cam_height, cam_half, cam_t
        .regs   r52, view_locx, view_locy, view_locz, view_basex, view_basey
        .regs   r57, view_basez, view_colx, view_coly, view_colz, view_rowx
        .regs   r62, view_rowy, view_rowz, view_focus, cam_focus
        .endshare

        .macro  view_axis dir, right, up, base, col, row
        DIVS    \right, cam_width, \col
        DIVS    \up, cam_height, \row
        SUBN    r0, \row, \row
        SUBN    \col, \right, \base
        MPYS    cam_half, \base, \base
        ADDN    \dir, \base, \base
        ADDN    \row, \up, cam_t
        MPYS    cam_half, cam_t, cam_t
        ADDN    \base, cam_t, \base
        .endm

        .kernel camera
camera:
        load_words scene_camera, 12, cam_locx, cam_at
        load_words scene_width, 2, cam_width, size_at
        load_word k_half, cam_half
        .if     LENS
        load_word scene_focus, cam_focus
        .endif
        .if     ORTHOGRAPHIC
        MPYS    cam_dirx, cam_dirx, view_locx
        MPYS    cam_diry, cam_diry, view_locy
        MPYS    cam_dirz, cam_dirz, view_locz
        ADDN    view_locx, view_locy, cam_t
        ADDN    cam_t, view_locz, cam_t
        SQRT    cam_t, cam_t
        DIVS    cam_dirx, cam_t, view_locx
        DIVS    cam_diry, cam_t, view_locy
        DIVS    cam_dirz, cam_t, view_locz
        copy_three cam_locx, cam_locy, cam_locz, cam_dirx, cam_diry, cam_dirz
        .if     LENS
        load_word k_one, cam_t
        DIVS    cam_t, cam_focus, view_focus
        .endif
        .else
        copy_three cam_locx, cam_locy, cam_locz, view_locx, view_locy, view_locz
        .if     LENS
        MPYS    cam_dirx, cam_dirx, view_focus
        MPYS    cam_diry, cam_diry, cam_t
        ADDN    view_focus, cam_t, view_focus
        MPYS    cam_dirz, cam_dirz, cam_t
        ADDN    view_focus, cam_t, view_focus
        SQRT    view_focus, view_focus
        DIVS    view_focus, cam_focus, view_focus
        .endif
        .endif
        view_axis cam_dirx, cam_rightx, cam_upx, view_basex, view_colx, view_rowx
        view_axis cam_diry, cam_righty, cam_upy, view_basey, view_coly, view_rowy
        view_axis cam_dirz, cam_rightz, cam_upz, view_basez, view_colz, view_rowz
        store_words view_locx, VIEW_SIZE, view, view_at
        BIM     0, link
        .endkernel
