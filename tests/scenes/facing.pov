// Two mirrors that face each other, seen from inside transparent glass, down to the
// level at which rays end.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 15 adc_bailout 1/20 }
background { rgb <.1, .15, .3> }
camera { location <.3, 1.2, -1.8> right 4/3*x angle 74 look_at <0, .9, 2> }
light_source { <1.5, 4, -1>, rgb .9 }
#default { finish { ambient .15 diffuse .7 } }
// the camera is inside this ball
sphere { <.3, 1.2, -1.8>, .5 pigment { rgbf <1, .95, .9, .95> }
    interior { ior 1.2 } }
box { <-2, 0, 2>, <2, 2.4, 2.1> pigment { rgb .05 }
    finish { reflection rgb <.9, .95, .9> } rotate 3*y }
box { <-2, 0, -3.1>, <2, 2.4, -3> pigment { rgb .05 }
    finish { reflection rgb <.95, .9, .9> } rotate -2*x }
difference { sphere { <-.8, .5, .6>, .5 } sphere { <-.8, .9, .2>, .4 }
    pigment { rgb <.8, .3, .2> } finish { reflection .3 } }
torus { .4, .12 rotate 60*x translate <.9, .5, .8>
    pigment { rgbt <.3, .7, .5, .5> } finish { reflection .2 } }
plane { y, 0 pigment { checker rgb .7, rgb .4 scale .5 } }
