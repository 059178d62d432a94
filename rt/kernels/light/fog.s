; fog.s - constant fogs, in both forms (FOG = 1).
;
; Each fog dims the colour that a ray sees at a distance d, including the rays
; spawned there, and adds its own colour:
;
;   a = max(e^(-d / distance), the fog's transmit)
;   colour = colour  product of a (1 - filter + filter fog)
;          + sum of (1 - a) fog
;
; A ray that hits nothing sees the background at fog_far.  e^(-d / distance) is
; 2^(d FOG_SCALE), computed by the second half of the power (power.s).
; Source: POV-Ray 3.7's fog of type 1, verified by its pictures.

        .record FOG
        .field  FOG_SCALE               ; -1 / (distance ln 2)
        .field  FOG_MIN               ; transmit
        .field  FOG_COLOR, 3
        .field  FOG_PASS, 3             ; 1 - filter + filter fog
        .endrecord

        .data
scene_fogs:     .word 0                 ; address of the first
scene_fog_count: .word 0                ; at least one
fog_far:        .word 2e10              ; POV-Ray's value
        .code

; pass = the product of the transmitted shares, haze = the sum of the haze; p_x
; = a, fog_share = 1 - a.
        .macro  fog_channel fog, fog_pass, pass, haze
        scale   p_x, \fog_pass, fog_work
        times   \pass, fog_work, \pass
        scaled_plus fog_share, \fog, \haze, \haze
        .endm

        .macro  fog_blend color, pass, haze
        times   \color, \pass, fog_work
        plus    fog_work, \haze, \color
        .endm

; Applies the fogs to the colour, seen at fog_distance.
        .macro  see_through_fog red, green, blue
        set     m_one, pass_red
        set     m_one, pass_green
        set     m_one, pass_blue
        set     m_zero, haze_red
        set     m_zero, haze_green
        set     m_zero, haze_blue
        load_words scene_fogs, 2, fog_at, fog_scale ; also fogs_left
fog_next\@:
        load_from fog_at, FOG_SIZE, fog_scale
        scale   fog_distance, fog_scale, p_x
        call_routine two_to, power_link
        not_below_number fog_least, p_x
        from    m_one, p_x, fog_share
        fog_channel fog_red, fog_pass_red, pass_red, haze_red
        fog_channel fog_green, fog_pass_green, pass_green, haze_green
        fog_channel fog_blue, fog_pass_blue, pass_blue, haze_blue
        IX      fog_at, 64 * FOG_SIZE
        IBXNE   fogs_left, m_index_minus_one, r0, fog_next\@, fogs_left
        fog_blend \red, pass_red, haze_red
        fog_blend \green, pass_green, haze_green
        fog_blend \blue, pass_blue, haze_blue
        .endm
