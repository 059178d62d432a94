// The camera is inside a ball with Fresnel reflection; nothing is transparent.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 adc_bailout 1/500 }
camera { location <.3, .4, -2.6> right 4/3*x angle 70 look_at <0, -.2, 0> }
light_source { <-1, 2.1, -1>, rgb .8 }
#default { finish { ambient .1 diffuse .6 } }

sphere {
    0, 3
    pigment { checker rgb <.6, .7, .9> rgb <.5, .4, .3> translate .13 }
    finish { reflection { .05, 1 fresnel } }
    interior { ior 1.4 }
}
sphere { <-.7, -.4, .3>, .6 pigment { rgb <.9, .4, .3> } finish { phong .5 } }
box { <.2, -1, 0>, <1, -.1, .7> pigment { rgb <.3, .6, .4> } rotate 20*y }
