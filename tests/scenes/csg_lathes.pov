// Lathes in solids: cut, cutting, open, inverted, with transparent parts; clipped lathes.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }
background { rgb <.25, .3, .4> }
camera { location <.3, 3.1, -7.5> look_at <0, .5, 0> angle 44 }
light_source { <-5, 8, -6>, .9 }
light_source { <4, 6, -7>, .4 }
plane { y, -1.2 pigment { checker rgb .3, rgb .7 } }

#declare Spool = lathe { linear_spline 12, <0, -1>, <.9, -1>, <1, -.8>, <.9, -.6>, <.4, -.45>,
    <.3, 0>, <.4, .45>, <.9, .6>, <1, .8>, <.9, 1>, <.2, 1>, <0, .3> }

difference { object { Spool } box { <0, -2, -2>, <2, 2, 0> }
    pigment { rgb <.8, .6, .3> } }
intersection { object { Spool } sphere { 0, .95 } lathe { 3, <.9, -1>, <.5, 0>, <.9, 1> }
    pigment { rgb <.4, .7, .5> } translate 2.4*x }
difference { cylinder { -y, y, .95 }
    lathe { 4, <0, -1.1>, <.7, -.2>, <.5, .4>, <.8, 1.1> } plane { z, -.3 }
    pigment { rgb <.5, .6, .9> } translate -2.4*x }
merge { object { Spool scale .5 } torus { .45, .14 } box { -.25, .25 rotate 45*y }
    pigment { rgbf <.9, .7, .7, .8> } interior { ior 1.3 } translate <-1.1, -.4, -2.4> }
intersection { box { -.7, .7 } lathe { 5, <.3, -.5>, <.6, 0>, <.3, .5>, <.2, 0>, <.3, -.5> inverse }
    plane { -z, .1 }
    pigment { rgb <.9, .5, .4> } rotate 20*y translate <1.2, -.4, -2.3> }
lathe { 3, <.6, 0>, <.2, .8>, <.5, 1.4> clipped_by { plane { x, .1 rotate 30*y } }
    pigment { rgb <.7, .7, .3> } translate <2.6, -1.2, -1.6> }
sphere { 0, .6 clipped_by { object { Spool scale .6 } } pigment { rgb <.8, .3, .7> }
    translate <-2.7, -.6, -1.7> }
union { object { Spool scale .4 } box { -.2, .2 translate .3*y } pigment { rgb <.9, .8, .6> }
    rotate 70*x translate <.1, -.7, -3> }
