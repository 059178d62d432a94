; sky_scalar.s - computes the colour that a ray without a hit sees in the sky.
;
;       CALL SKY (DIRECTION, COLOUR)
;
; Both have three words.  The order of the operations is that of
; pigment_vector.s.
; Source: POV-Ray's sky_sphere.

        .data
        .include "light/sky.s"
sky_list:       .descriptor 3, sky_direction
                .descriptor 3, sky_colour
sky_direction:  .space 3
sky_colour:     .space 3
        .code

; Sets the three registers from `first` on to the colour in the direction that
; the three registers from `from` on hold.
        .macro  see_sky from, first
        store_words \from, 3, sky_direction
        call    sky, sky_list
        load_words sky_colour, 3, \first
        .endm

        .kernel shade
sky:
        store_words r32, SKY_REGISTERS, pigment_save
        LOD     [arguments], a_point
        LOD     [arguments, m_index_one], a_color
        SWAP    [a_point], px, [r0]
        .if     PATTERNS
        load_words sky_map, MAP_SIZE, map_function
        IBXEQ   map_function, r0, r0, sky_gradient
        load_words sky_pattern, 12, sh0
        pattern_colour
        BIM     sky_found
sky_gradient:
        .endif
        load_words scene_sky, 6, sh0
        gradient_colour
sky_found:
        SWAP    [r0], color0r, [a_color]
        leave   pigment_save, SKY_REGISTERS
        .endkernel
